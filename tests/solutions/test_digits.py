"""Closed forms of the solutions keep the digits that plain formulas lose, compared with fifty digits of mpmath.

Each function yields a result, its exact value, and the size of the terms of the sum, or 0 if it is no larger.
"""

import math

import mpmath as mp
import numpy as np
import pytest

from tam570_grader.checks.assignments import solution

ROUNDINGS = 1e-13  # relative; a closed form of a dozen operations
NEXT_TO_TOP = math.pi - 1e-8  # rad
BODY, SEPARATRIX = (1.0, 2.0, 2.7), (0.0, 1.0, 1e-12)  # kg m^2; omega near the separatrix, rad/s


def pendulum():
    """Yield the potential energy of small swings, and periods up to amplitudes near the top."""
    hw, rod = solution("hw01_simple_pendulum"), {"length": 1.7, "gravity": 9.3}
    for theta in (1e-8, 1e-3, 1.0, NEXT_TO_TOP):
        square = mp.sin(mp.mpf(theta) / 2) ** 2
        yield hw.energy_balance(theta, 0.0, mass=2.0, **rod)[2], 4 * mp.mpf(9.3) * mp.mpf(1.7) * square, 0
        yield hw.period(theta, **rod), 4 * mp.sqrt(mp.mpf(1.7) / mp.mpf(9.3)) * mp.ellipk(square), 0


def spring():
    """Yield the height after a short time, in which a soft spring hardly differs from free fall."""
    hw = solution("hw04_hanging_spring")
    for stiffness in (1e-12, 1e-6, 1.0):
        k, t = mp.sqrt(mp.mpf(stiffness)), mp.mpf(0.7)
        z = hw.solution(np.array([0.7]), np.zeros(3), np.zeros(3), mass=1.0, stiffness=stiffness, gravity=9.3)[0, 2]
        yield z, -mp.mpf(9.3) * (1 - mp.cos(k * t)) / k**2, 0


def circle():
    """Yield the components of the nearest state on a circle of any size."""
    hw = solution("hw05_constrained_pendulum")
    for length in (1e-6, 1.7, 1e6):
        state = np.array([3e-5, -2.0, 1.4e3, 7.0])
        x, y, vx, vy = map(mp.mpf, state)
        distance, across = mp.hypot(x, y), (x * vy - y * vx) / (x**2 + y**2)
        expected = x / distance * length, y / distance * length, -across * y, across * x
        for result, value in zip(hw.consistent_state(state, length=length), expected, strict=True):
            yield result, value, 0


def bars():
    """Yield accelerations and frequencies of bars that are nearly massless or have very different lengths."""
    hw, g = solution("hw07_double_pendulum"), 9.81
    theta, omega = np.array([1.0, 1.0 + 1e-9]), np.array([-1.7, 2.9])
    for masses in ((1.0, 1.0), (1.0, 1e-9), (1e-9, 1.0), (1e6, 1e-6)):
        for lengths in ((1.0, 1.6), (1e-3, 1e3), (1e6, 1e-6)):
            pairs = (masses, lengths, theta, omega)
            (m1, m2), (l1, l2), (th1, th2), (om1, om2) = (map(mp.mpf, map(float, pair)) for pair in pairs)
            c, s = (m2 * l1 * l2 / 2 * f(th1 - th2) for f in (mp.cos, mp.sin))
            M = mp.matrix([[(m1 / 3 + m2) * l1**2, c], [c, m2 * l2**2 / 3]])
            k1, k2 = mp.mpf(g) * (m1 / 2 + m2) * l1, mp.mpf(g) * m2 * l2 / 2
            expected = mp.lu_solve(M, mp.matrix([-s * om2**2 - k1 * mp.sin(th1), s * om1**2 - k2 * mp.sin(th2)]))
            both = {"masses": np.array(masses), "lengths": np.array(lengths), "gravity": g}
            lagrangian, free = hw.angular_acceleration(theta, omega, **both), hw.on_the_fly(theta, omega, **both)[0]
            for k in range(2):  # determinants go down to 1/12; ten equations round more than two
                size = 12 * (max(lengths * omega**2) + g) / lengths[k]
                yield lagrangian[k], expected[k], size
                yield free[k], expected[k], 10 * size
            M[0, 1] = M[1, 0] = m2 * l1 * l2 / 2
            coefficients = [M[0, 0] * M[1, 1] - M[0, 1] ** 2, -(M[0, 0] * k2 + M[1, 1] * k1), k1 * k2]
            squares = sorted(map(mp.re, mp.polyroots(coefficients, maxsteps=200, extraprec=200)))
            for result, square in zip(hw.small_oscillation_frequencies(**both), squares, strict=True):
                yield result, mp.sqrt(square), 0


def book():
    """Yield the errors of axis and angle, at most 1e-14, for turns next to 0 and to pi."""
    hw, n = solution("hw09_book"), mp.matrix([2, -1, 2]) / 3
    skew = mp.matrix([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])
    for angle in (mp.mpf(1e-9), mp.mpf(1), mp.pi - mp.mpf(1e-9)):
        R = mp.eye(3) + mp.sin(angle) * skew + (1 - mp.cos(angle)) * skew * skew
        axis, result = hw.axis_angle(np.array(R.tolist(), float))
        yield from ((mp.mpf(x) - y, 0, 0.1) for x, y in zip(axis, n, strict=True))
        yield mp.mpf(result) - angle, 0, 0.1


def body():
    """Yield the period of a tumble for random inertias, and near the separatrix."""
    hw, rng = solution("hw10_free_rigid_body"), np.random.default_rng(10)
    random = [(np.sort(m.sum() - m), rng.normal(size=3)) for m in 10 ** rng.uniform(-6, 0, (50, 3))]
    near = [(BODY, omega) for omega in (SEPARATRIX, (1e-12, -1, 0), (0, 1, 1e-150), (1e-8, 1, 1e-12))]
    for inertia, omega in random + near:
        with mp.workdps(400):
            (A, B, C), (p, q, r) = (map(mp.mpf, map(float, values)) for values in (inertia, omega))
            double, square = A * p * p + B * q * q + C * r * r, (A * p) ** 2 + (B * q) ** 2 + (C * r) ** 2
            A, C = (C, A) if square < double * B else (A, C)
            along = (C - B) * (square - double * A)
            m = (B - A) * (double * C - square) / along
            yield hw.tumble_period(omega, inertia=inertia), 4 * mp.ellipk(m) * mp.sqrt(A * B * C / along), 0


def bead():
    """Yield the period for any steepness, which is curvature times amplitude."""
    hw, c, g = solution("hw12_bead_on_wire"), mp.mpf(0.37), mp.mpf(9.3)
    for amplitude in (1e-8, 1e-3, 1.0, 30.0, 1e4):
        expected = 4 * mp.ellipe(-((2 * c * mp.mpf(amplitude)) ** 2)) / mp.sqrt(2 * g * c)
        yield hw.period(amplitude, curvature=0.37, gravity=9.3), expected, 0


def cylinder():
    """Yield the inertia about the contact for an offset near the radius."""
    hw = solution("hw13_rolling_cylinder")
    for offset in (1.7 * (1 - 1e-6), 1.7 * (1 - 1e-9)):
        r, e, phi = map(mp.mpf, (1.7, offset, 1e-7))
        result = hw.contact_inertia(1e-7, mass=2.0, radius=1.7, offset=offset, inertia=0.0)
        yield result, 2 * (r**2 + e**2 - 2 * r * e * mp.cos(phi)), 0


@pytest.mark.parametrize("results", [pendulum, spring, circle, bars, book, body, bead, cylinder])
def test_closed_forms_keep_their_digits(results):
    with mp.workdps(50):
        for result, expected, size in results():
            assert abs(result - expected) <= ROUNDINGS * max(abs(expected), size)


def test_the_period_on_the_separatrix_is_infinite():
    """With integers, both sides of C (C - B) r^2 = A (B - A) p^2 are equal without rounding."""
    hw = solution("hw10_free_rigid_body")
    bodies = [(a, b, c) for c in range(3, 40) for b in range(2, c) for a in range(max(1, c - b), b)]
    motions = [(A, B, C, math.isqrt(C * (C - B)), math.isqrt(A * (B - A))) for A, B, C in bodies]
    equal = [(A, B, C, p, r) for A, B, C, p, r in motions if p * p == C * (C - B) and r * r == A * (B - A)]
    assert len(equal) > 10
    for A, B, C, p, r in [*equal, (8, 17, 25, 5, 3), (3, 4, 6, -2, 1)]:
        assert hw.tumble_period(np.array([p, 1.0, r]), inertia=np.array([A, B, C], float)) == math.inf
