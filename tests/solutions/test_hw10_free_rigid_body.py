"""hw10's reference solution: its laws, elliptic functions and turns at 50 digits, and the figures over 1e3 s."""

import math

import mpmath
import numpy as np
import pytest

from tam570.invariants import drift, rotation_defect
from tam570_grader.checks import assignments

hw = assignments.solution("hw10_free_rigid_body")

DRAW = np.random.default_rng(10)
DIGITS = 1e-14  # a dozen roundings
FIGURE = 1e-11  # of energy, angular momentum and R^T R over 1e3 s
BODY = (1.0, 2.0, 2.7)
BODIES = {
    "general": BODY,
    "light": (1e-6, 2e-6, 2.7e-6),
    "heavy": (2.7e6, 1e6, 2e6),
    "disk": (0.3, 0.3, 0.6),
    "rod": (1.0, 1.0, 1e-6),
    "thin plate": (1e-6, 1.0, 1.0 + 1e-6),
    "two larger ones equal": (0.5, 0.8, 0.8),
    "ball": (0.4, 0.4, 0.4),
}
STARTS = {  # omega, rad/s
    "general": (0.7, -1.1, 0.9),
    "round the first axis": (1.2, 0.4, 0.1),
    "middle axis": (0.01, 1.0, 0.02),
    "next to the separatrix": (0.0, 1.0, 1e-12),
    "pure spin": (0.0, 1.0, 0.0),
}


def a_body():
    """Any inertias that a body can have, sorted, over twelve decades."""
    masses = 10 ** DRAW.uniform(-6, 0, 3)
    return np.sort(masses.sum() - masses) * 10 ** DRAW.uniform(-6, 6)


def an_attitude():
    R = np.linalg.qr(DRAW.normal(size=(3, 3)))[0]
    return R * np.linalg.det(R)


def precise(values):
    return [mpmath.mpf(float(value)) for value in values]


# Pointwise


def test_the_angular_momentum_in_space_does_not_change():
    for _ in range(200):
        body, R, omega = DRAW.permutation(a_body()), an_attitude(), DRAW.normal(size=3)
        gyroscopic = hw.attitude_rate(R, omega) @ (body * omega)
        inertial = R @ (body * hw.euler_equations(omega, inertia=body))
        np.testing.assert_allclose(gyroscopic, -inertial, rtol=0, atol=DIGITS * max(body) * (omega @ omega))


def test_energy_and_angular_momentum_belong_together():
    for _ in range(50):
        body, R, omega = a_body(), an_attitude(), DRAW.normal(size=3)
        H = hw.angular_momentum(R, omega, inertia=body)
        assert 2 * hw.energy(omega, inertia=body) == pytest.approx(H @ R @ omega, rel=DIGITS)


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
    with mpmath.workdps(50):
        angles, omega = precise([DRAW.normal(), theta, DRAW.normal()]), precise(DRAW.normal(size=3))
        rates = precise(hw.euler_rates_313([float(x) for x in angles], [float(w) for w in omega]))
        h = mpmath.mpf(10) ** -20
        ahead, back = ([x + sign * h * rate for x, rate in zip(angles, rates, strict=True)] for sign in (1, -1))
        body_rate = euler_matrix(*angles).T * (euler_matrix(*ahead) - euler_matrix(*back)) / (2 * h)
        found = body_rate[2, 1], body_rate[0, 2], body_rate[1, 0]
        scale = 1 + max(map(abs, rates))
        assert max(abs(x - w) for x, w in zip(found, omega, strict=True)) <= DIGITS * scale


@pytest.mark.parametrize("theta", [0.0, math.pi, -2 * math.pi, 9e-13])
def test_euler_rates_are_refused(theta):
    with pytest.raises(ValueError, match="not determined"):
        hw.euler_rates_313((0.3, theta, 0.4), (1.0, 2.0, 3.0))


# The motion


def invariant_drifts(body, omega, times):
    R = an_attitude()
    omegas, rotations = hw.simulate(times, R, omega, inertia=body)
    np.testing.assert_allclose(omegas[0], omega, rtol=0, atol=0)
    np.testing.assert_allclose(rotations[0], R, rtol=0, atol=1e-15)
    states = np.hstack([omegas, rotations.reshape(-1, 9)])
    momenta = drift(lambda y: hw.angular_momentum(y[3:].reshape(3, 3), y[:3], inertia=body), states)
    return (drift(lambda w: hw.energy(w, inertia=body), omegas).max(), momenta.max(), rotation_defect(rotations).max())


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("start", ["general", "next to the separatrix"])
def test_the_invariants_stay(body, start):
    assert max(invariant_drifts(BODIES[body], STARTS[start], np.linspace(-2.0, 20.0, 23))) <= FIGURE / 10


@pytest.mark.slow
@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("start", STARTS)
def test_the_invariants_stay_for_1000_s(body, start):
    assert max(invariant_drifts(BODIES[body], STARTS[start], np.linspace(3.0, 1003.0, 201))) <= FIGURE


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


@pytest.mark.parametrize("omega", [(0.7, 1.1, 0.9), (-0.2, 1.0, 0.5), (1.2, 0.4, 0.1), (0.8, 1.5, 0.2)])
def test_omega_follows_elliptic_functions_on_both_sides(omega):
    times = np.array([0.3, 1.0, 2.7, 9.1, 20.0, 50.0])
    with mpmath.workdps(50):
        right = elliptic(times, omega, BODY)
    omegas, _ = hw.simulate(times, np.eye(3), omega, inertia=BODY)
    np.testing.assert_allclose(omegas, right, rtol=0, atol=1e-11)


def test_omega_follows_elliptic_functions_next_to_the_separatrix():
    # After the first flip at 59 s omega comes to 1e-24 of the middle axis, and roundings of 1e-16 decide on the second.
    times = np.array([0.0, 1.0, 10.0, 30.0, 50.0, 55.0, 58.0, 60.0, 62.0])
    with mpmath.workdps(60):
        right = elliptic(times, STARTS["next to the separatrix"], BODY)
    omegas, _ = hw.simulate(times, np.eye(3), STARTS["next to the separatrix"], inertia=BODY)
    assert right[0, 1] * right[-1, 1] < 0  # it did flip
    # the two small components are known to 13 digits as they grow, and a shift in time of 1e-13 follows
    np.testing.assert_allclose(omegas, right, rtol=1e-11, atol=1e-23)


@pytest.mark.parametrize("ratio", [2.0, 1.3, 1.0, 0.4, 1e-6])
def test_the_closed_form_of_a_symmetric_body(ratio):
    body, omega, times = (0.7, 0.7, 0.7 * ratio), (0.3, -0.4, 1.7), np.array([-2.0, -1.3, 0.0, 4.0, 15.0])
    closed = hw.symmetric_solution(times, omega, inertia=body)
    omegas, _ = hw.simulate(times, np.eye(3), omega, inertia=body)
    np.testing.assert_allclose(closed, omegas, rtol=0, atol=1e-12)
    with mpmath.workdps(50):
        A, _, C = precise(body)
        for row, t in zip(closed, precise(times), strict=True):
            angle = (C - A) / A * mpmath.mpf(1.7) * (t + 2)
            across = mpmath.mpc(0.3, -0.4) * mpmath.expj(angle)
            assert abs(mpmath.mpc(*row[:2]) - across) <= DIGITS * (1 + abs(angle))  # the angle itself is rounded


def turned_about(direction, vectors):
    """Total angle by which vectors have gone round a direction."""
    x, y = np.linalg.svd(direction[None, :])[2][1:]
    y = y * np.sign(np.dot(np.cross(x, y), direction))
    angles = np.unwrap(np.arctan2(vectors @ y, vectors @ x))
    return angles[-1] - angles[0]


@pytest.mark.parametrize("omega", [(0.5, -0.2, 1.0), (0.001, 0.0, 1.0), (1.0, 0.5, -0.3)])
def test_the_wobble_rate_is_that_of_the_simulation(omega):
    body, times = (0.7, 0.7, 1.1), np.linspace(0.0, 30.0, 300)
    _, rotations = hw.simulate(times, an_attitude(), omega, inertia=body)
    H = hw.angular_momentum(rotations[0], omega, inertia=body)
    rate = turned_about(H, rotations[:, :, 2]) / 30.0
    # a small tilt, 1e-3 here, divides the error of the attitude
    assert hw.wobble_rate(omega, inertia=body) == pytest.approx(rate, rel=1e-10)


def test_a_flat_disk_wobbles_twice_a_turn():
    for tilt in (1e-2, 1e-3, 1e-4):
        assert hw.wobble_rate((tilt, 0.0, 1.0), inertia=(0.3, 0.3, 0.6)) == pytest.approx(2.0, abs=tilt**2)


# Stability and tumbling


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_growth_rates_are_those_of_the_simulation(axis):
    spin, small = -1.3, 1e-6
    square = hw.growth_rate_squared(axis, spin, inertia=BODY)
    omega = spin * np.eye(3)[axis] + small * np.eye(3)[(axis + 1) % 3]
    times = np.linspace(0.0, 4.0, 9)
    omegas, _ = hw.simulate(times, np.eye(3), omega, inertia=BODY)
    grown = np.cosh(np.sqrt(complex(square)) * times).real
    # terms of the second order are small^2 beside 1
    np.testing.assert_allclose(omegas[:, (axis + 1) % 3] / small, grown, rtol=0, atol=1e-9)


def test_growth_rates_keep_their_digits():
    with mpmath.workdps(50):
        for _ in range(200):
            body, spin, axis = DRAW.permutation(a_body()), float(DRAW.normal()), int(DRAW.integers(3))
            i, j, k = (precise(body)[(axis + n) % 3] for n in range(3))
            right = (k - i) / j * (i - j) / k * mpmath.mpf(spin) ** 2
            assert abs(hw.growth_rate_squared(axis, spin, inertia=body) - right) <= DIGITS * abs(right)


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
                right = precise_period(omega, body)
                assert abs(hw.tumble_period(omega, inertia=body) - right) <= DIGITS * right


@pytest.mark.parametrize("omega", [(0, 1, 1e-12), (1e-12, -1, 0), (0, 1, 1e-150), (1e-8, 1, 1e-12)])
def test_the_period_next_to_the_separatrix(omega):
    with mpmath.workdps(400):
        right = precise_period(omega, BODY)
        assert abs(hw.tumble_period(omega, inertia=BODY) - right) <= DIGITS * right


def test_the_period_at_its_limits():
    for axis in (0, 2):
        spin = -1.7 * np.eye(3)[axis]
        small = 2 * math.pi / math.sqrt(-hw.growth_rate_squared(axis, 1.7, inertia=BODY))
        assert hw.tumble_period(spin, inertia=BODY) == pytest.approx(small, rel=DIGITS)
        assert hw.tumble_period(spin + [1e-5, 1e-5, 1e-5], inertia=BODY) == pytest.approx(small, rel=1e-4)
    for omega in ((0, 1, 0), (0, -0.3, 0), (0, 0, 0)):
        assert hw.tumble_period(omega, inertia=BODY) == math.inf
    assert hw.tumble_period((-2, 0.7, 1), inertia=(3, 4, 6)) == math.inf  # 3 (4 - 3) 2^2 = 6 (6 - 4) 1^2


@pytest.mark.parametrize("omega", [(0.7, 1.1, 0.9), (1.2, 0.4, 0.1), (0.01, 1.0, 0.02)])
def test_omega_is_back_after_a_period_and_not_before(omega):
    period = hw.tumble_period(omega, inertia=BODY)
    omegas, _ = hw.simulate([1.0, 1.0 + period / 2, 1.0 + period], np.eye(3), omega, inertia=BODY)
    np.testing.assert_allclose(omegas[2], omega, rtol=0, atol=1e-11)
    assert np.abs(omegas[1] - omega).max() > 0.1


@pytest.mark.slow
def test_omega_is_back_after_a_thousand_flips():
    omega = STARTS["middle axis"]
    period = hw.tumble_period(omega, inertia=BODY)
    omegas, _ = hw.simulate(np.arange(501.0) * period, np.eye(3), omega, inertia=BODY)
    # each passage of the middle axis multiplies the rounding errors by 1/0.02, and the next undoes it
    np.testing.assert_allclose(omegas, np.broadcast_to(omega, omegas.shape), rtol=0, atol=1e-9)


# Drawing


def test_the_box_keeps_lengths_and_angles():
    R, size = an_attitude(), np.array([0.3, 1.0, 7.0])
    ends = hw.wireframe(R, size=size) @ R / size
    assert len({tuple(np.sign(edge).ravel()) for edge in np.round(ends, 9)}) == 12
    np.testing.assert_allclose(np.abs(ends), 0.5, rtol=1e-13)
    np.testing.assert_allclose(np.abs(ends[:, 1] - ends[:, 0]).sum(axis=1), 1.0, rtol=1e-13)


def test_the_paths_of_the_rim_start_where_the_points_are():
    from matplotlib.figure import Figure

    ax, R = Figure().subplots(), an_attitude()
    hw.plot_rim_paths(ax, [0.0, 0.1, 0.2], R, (0.1, 0.0, 1.0), inertia=(0.3, 0.3, 0.6), radius=0.5)
    starts = [line.get_xydata()[0] for line in ax.lines]
    np.testing.assert_allclose(starts, [0.5 * R[1:, 0], 0.5 * R[1:, 1]], atol=1e-15)
    assert (ax.get_xlabel(), ax.get_ylabel(), ax.get_aspect()) == ("y (m)", "z (m)", 1.0)


def test_points_a_quarter_of_a_turn_apart_run_on_tilted_circles_and_opposite_ones_on_one():
    """Near the axis of a disk, C = 2 A: the planes of the paths, fitted over a turn."""
    omega = np.array([0.0, 0.6, 6.0])
    _, rotations = hw.simulate(np.linspace(0.0, 2 * math.pi / 6.0, 201), np.eye(3), omega, inertia=(1.0, 1.0, 2.0))
    first, second, opposite = (
        np.linalg.svd(path)[2][2] for path in (rotations[:, :, 0], rotations[:, :, 1], -rotations[:, :, 0])
    )
    assert math.degrees(math.acos(abs(first @ second))) == pytest.approx(5.7, abs=0.1)
    assert abs(first @ opposite) == pytest.approx(1.0, abs=1e-12)


def test_the_period_on_the_separatrix_is_infinite():
    """Where both sides of C (C - B) r^2 = A (B - A) p^2 are whole numbers, no rounding hides that they are equal."""
    found = 0
    for C in range(3, 40):
        for B in range(2, C):
            for A in range(max(1, C - B), B):
                p, r = math.isqrt(C * (C - B)), math.isqrt(A * (B - A))
                if p * p == C * (C - B) and r * r == A * (B - A):
                    found += 1
                    assert hw.tumble_period(np.array([p, 1.0, r]), inertia=np.array([A, B, C], float)) == math.inf
    assert found > 10
    omega, inertia = np.array([5.0, 1.0, 3.0]), np.array([8.0, 17.0, 25.0])  # 8 9 5^2 = 25 8 3^2
    assert hw.tumble_period(omega, inertia=inertia) == math.inf
