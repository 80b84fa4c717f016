"""hw10's solution against fifty digits and more: Euler rates, the tumble period."""

import math

import mpmath
import numpy as np
import pytest

from tam570_grader.checks import assignments

hw = assignments.solution("hw10_free_rigid_body")

DRAW = np.random.default_rng(10)
DIGITS = 1e-14  # a dozen roundings
BODY = (1.0, 2.0, 2.7)
NEXT_TO_THE_SEPARATRIX = (0.0, 1.0, 1e-12)  # omega, rad/s


def a_body():
    """Any inertias that a body can have, sorted, over twelve decades."""
    masses = 10 ** DRAW.uniform(-6, 0, 3)
    return np.sort(masses.sum() - masses) * 10 ** DRAW.uniform(-6, 6)


def precise(values):
    return [mpmath.mpf(float(value)) for value in values]


def euler_matrix(psi, theta, phi):
    """Rz(psi) Rx(theta) Rz(phi) at the current precision."""

    def about(k, angle):
        c, s = mpmath.cos(angle), mpmath.sin(angle)
        R, i, j = mpmath.eye(3), (k + 1) % 3, (k + 2) % 3
        R[i, i], R[i, j], R[j, i], R[j, j] = c, -s, s, c
        return R

    return about(2, psi) * about(0, theta) * about(2, phi)


@pytest.mark.parametrize("theta", [1.1, -0.4, 4.0, 1e-3, math.pi - 1e-6, 3e-12])
def test_euler_rates_make_the_attitude_rate_at_50_digits(theta):
    angles, omega = precise([DRAW.normal(), theta, DRAW.normal()]), precise(DRAW.normal(size=3))
    rates = precise(hw.euler_rates_313([float(x) for x in angles], [float(w) for w in omega]))
    h = mpmath.mpf(10) ** -20
    ahead, back = ([x + sign * h * rate for x, rate in zip(angles, rates, strict=True)] for sign in (1, -1))
    body_rate = euler_matrix(*angles).T * (euler_matrix(*ahead) - euler_matrix(*back)) / (2 * h)
    result = body_rate[2, 1], body_rate[0, 2], body_rate[1, 0]
    scale = 1 + max(map(abs, rates))
    assert max(abs(x - w) for x, w in zip(result, omega, strict=True)) <= DIGITS * scale


def elliptic(times, omega, body):
    """omega at 50 digits by Jacobi's functions; A < B < C, first component or second zero or positive at the start."""
    (A, B, C), (p, q, r) = precise(body), precise(omega)
    double, square = A * p * p + B * q * q + C * r * r, (A * p) ** 2 + (B * q) ** 2 + (C * r) ** 2
    last = square > double * B
    if not last:
        A, C, p, r = C, A, r, p
    beside, along = double * C - square, square - double * A
    a, b, c = (mpmath.sqrt(x) for x in (beside / (A * (C - A)), beside / (B * (C - B)), along / (C * (C - A))))
    m, n = (B - A) * beside / ((C - B) * along), mpmath.sqrt((C - B) * along / (A * B * C))
    start = mpmath.ellipf(mpmath.atan2(q / b, p / a), m)
    rows = []
    for t in times:
        sn, cn, dn = (mpmath.ellipfun(name, start + n * (mpmath.mpf(t) - times[0]), m=m) for name in ("sn", "cn", "dn"))
        row = [a * cn, b * sn, c * dn]
        rows.append([float(x) for x in (row if last else row[::-1])])
    return np.array(rows)


def precise_period(omega, body):
    (A, B, C), (p, q, r) = precise(body), precise(omega)
    double, square = A * p * p + B * q * q + C * r * r, (A * p) ** 2 + (B * q) ** 2 + (C * r) ** 2
    if square < double * B:
        A, C = C, A
    along = (C - B) * (square - double * A)
    m = (B - A) * (double * C - square) / along
    return 4 * mpmath.ellipk(m) * mpmath.sqrt(A * B * C / along)


def test_the_period_is_4k_at_60_digits():
    with mpmath.workdps(60):
        for _ in range(200):
            body, omega = a_body(), DRAW.normal(size=3) * 10 ** DRAW.uniform(-9, 3, 3)
            if body[0] < body[1] < body[2]:
                expected = precise_period(omega, body)
                assert abs(hw.tumble_period(omega, inertia=body) - expected) <= DIGITS * expected


@pytest.mark.parametrize("omega", [NEXT_TO_THE_SEPARATRIX, (1e-12, -1, 0), (0, 1, 1e-150), (1e-8, 1, 1e-12)])
def test_the_period_next_to_the_separatrix(omega):
    with mpmath.workdps(400):
        expected = precise_period(omega, BODY)
        assert abs(hw.tumble_period(omega, inertia=BODY) - expected) <= DIGITS * expected


def test_the_period_on_the_separatrix_is_infinite():
    """Where both sides of C (C - B) r^2 = A (B - A) p^2 are whole numbers, no rounding hides that they are equal."""
    bodies = [(a, b, c) for c in range(3, 40) for b in range(2, c) for a in range(max(1, c - b), b)]
    motions = [(A, B, C, math.isqrt(C * (C - B)), math.isqrt(A * (B - A))) for A, B, C in bodies]
    equal = [(A, B, C, p, r) for A, B, C, p, r in motions if p * p == C * (C - B) and r * r == A * (B - A)]
    assert len(equal) > 10
    for A, B, C, p, r in [*equal, (8, 17, 25, 5, 3), (3, 4, 6, -2, 1)]:
        assert hw.tumble_period(np.array([p, 1.0, r]), inertia=np.array([A, B, C], float)) == math.inf
