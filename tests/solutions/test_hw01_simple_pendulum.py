"""hw01: the reference against 50 digits of mpmath, against SymPy, and against its own laws."""

import math

import mpmath
import numpy as np
import pytest
import sympy

from tam570_grader.checks import assignments

hw = assignments.solution("hw01_simple_pendulum")
DRAW = np.random.default_rng(1)
PENDULUM = {"length": 1.7, "gravity": 9.3}  # m, m/s^2
K = math.sqrt(9.3 / 1.7)  # 1/s
TINY, NEXT_TO_TOP = 1e-8, math.pi - 1e-8  # rad
ROUNDINGS = 1e-13  # relative, of a closed form
BALANCES = ("linear_momentum_balance", "angular_momentum_balance", "energy_balance", "power_balance", "virtual_work")
ANGLES = [*DRAW.uniform(-20, 20, 20), 0.0, TINY, NEXT_TO_TOP]


@pytest.fixture(autouse=True)
def fifty_digits():
    with mpmath.workdps(50):
        yield


def pendulums(number):
    """Masses and lengths over twelve decades."""
    return [
        {"mass": 10 ** DRAW.uniform(-6, 6), "length": 10 ** DRAW.uniform(-6, 6), "gravity": DRAW.uniform(0, 30)}
        for _ in range(number)
    ]


@pytest.mark.parametrize("theta", ANGLES)
def test_the_balances_hold_to_the_last_digits(theta):
    """Route: the same quantities from r, v, F in mpmath."""
    for pendulum in pendulums(4):
        omega = DRAW.normal() * 3
        m, r, g, th, om = (mpmath.mpf(x) for x in (*pendulum.values(), theta, omega))
        s, c = mpmath.sin(th), mpmath.cos(th)
        expected = {
            "linear_momentum_balance": (-g / r * s, m * r * om**2 + m * g * c),
            "angular_momentum_balance": (-g / r * s, m * r**2 * om, -m * g * r * s),
            "energy_balance": (-g / r * s, m * (r * om) ** 2 / 2, m * g * r * (1 - c)),
            "power_balance": (-g / r * s, -m * g * r * s * om),
            "virtual_work": (-g / r * s, -m * g * r * s),
        }
        largest = {"linear_momentum_balance": (0, m * r * om**2 + m * g)}  # what the tension's two terms are rounded to
        for name, values in expected.items():
            scales = largest.get(name, (0,) * len(values))
            for found, value, scale in zip(getattr(hw, name)(theta, omega, **pendulum), values, scales, strict=True):
                assert abs(found - value) <= ROUNDINGS * max(abs(value), scale)


def test_alpha_is_the_slope_of_the_energy():
    """Route: a complex step through the energy, written in complex numbers."""
    for pendulum in pendulums(10):
        theta, step = DRAW.uniform(-9, 9), 1e-30
        weight = pendulum["mass"] * pendulum["gravity"] * pendulum["length"]
        slope = weight * (1 - np.cos(theta + 1j * step)).imag / step
        inertia = pendulum["mass"] * pendulum["length"] ** 2
        for name in BALANCES:
            assert getattr(hw, name)(theta, 0.0, **pendulum)[0] == pytest.approx(-slope / inertia, rel=ROUNDINGS)


def test_the_potential_energy_changes_as_that_slope_says():
    """Route: differences of the energy, of sixth order."""
    pendulum, step = {"mass": 2.3, **PENDULUM}, 1e-2
    weights = {1: 3 / 4, 2: -3 / 20, 3: 1 / 60}
    for theta in DRAW.uniform(-9, 9, 10):
        height = {n: hw.energy_balance(theta + n * step, 0.0, **pendulum)[2] for n in (-3, -2, -1, 1, 2, 3)}
        slope = sum(w * (height[n] - height[-n]) for n, w in weights.items()) / step
        moment = hw.angular_momentum_balance(theta, 0.0, **pendulum)[2]
        assert slope == pytest.approx(-moment, abs=1e-10 * 2.3 * 1.7 * 9.3)  # step^6 = 1e-12, times 36/7!


def test_the_formulas_are_those_of_lagrange():
    """Route: SymPy differentiates along an unknown function of time."""
    t, theta, omega = sympy.symbols("t theta omega")
    angle = sympy.Function("angle")(t)
    along = hw.lagrangian().subs({omega: angle.diff(t), theta: angle})
    equation = along.diff(angle.diff(t)).diff(t) - along.diff(angle)
    alpha = hw.lagrange_equation()
    residual = equation.subs(angle.diff(t, 2), alpha.subs(theta, angle)).subs(angle, theta)
    assert sympy.simplify(residual) == 0
    assert {symbol.name for symbol in alpha.free_symbols} == {"theta", "l", "g"}


@pytest.mark.parametrize("amplitude", [TINY, 1e-3, 0.5, 1.0, 2.0, 3.0, math.pi - 1e-3, NEXT_TO_TOP])
def test_the_period_is_an_elliptic_integral(amplitude):
    """Route: Legendre's K in mpmath."""
    m = mpmath.sin(mpmath.mpf(amplitude) / 2) ** 2
    expected = 4 * mpmath.sqrt(mpmath.mpf(1.7) / mpmath.mpf(9.3)) * mpmath.ellipk(m)
    assert abs(hw.period(amplitude, **PENDULUM) / expected - 1) < ROUNDINGS


def test_the_period_has_the_known_limits():
    """1 + A^2/16 + 11 A^4/3072 for small amplitudes; ln(8/delta) next to the top."""
    small = 2 * math.pi / K
    for amplitude in (1e-3, 1e-2):
        series = 1 + amplitude**2 / 16 + 11 * amplitude**4 / 3072
        assert hw.period(amplitude, **PENDULUM) == pytest.approx(small * series, rel=1e-15 + amplitude**6)
    for delta in (1e-4, 1e-6):
        logarithm = 4 / K * math.log(8 / delta)
        assert hw.period(math.pi - delta, **PENDULUM) == pytest.approx(logarithm, rel=delta**2 + 1e-9)


@pytest.mark.parametrize("gravity", [9.3, 1e-12, 0.0])
def test_the_small_angle_solution_is_that_of_mpmath(gravity):
    """Route: the matrix exponential in mpmath."""
    t = DRAW.uniform(-20, 20, 10)
    found = hw.small_angle_solution(t, 0.3, -0.7, length=1.7, gravity=gravity)
    rates = mpmath.matrix([[0, 1], [-mpmath.mpf(gravity) / mpmath.mpf(1.7), 0]])
    for row, time in zip(found, t, strict=True):
        expected = mpmath.expm(rates * mpmath.mpf(time)) * mpmath.matrix([0.3, -0.7])
        np.testing.assert_allclose(row, [float(x) for x in expected], rtol=0, atol=ROUNDINGS * 20)


def test_the_error_of_the_action_falls_with_the_square_of_the_step():
    """Route: quadrature in mpmath along a path that is no motion."""

    def integrand(s):
        rate = 1 - mpmath.cos(3 * s)
        return 2 * (1.7 * rate) ** 2 / 2 - 2 * 9.3 * 1.7 * (1 - mpmath.cos(s - mpmath.sin(3 * s) / 3))

    exact = mpmath.quad(integrand, [0, 1, 2])
    errors = []
    for steps in (100, 200, 400):
        t = np.linspace(0, 2, steps + 1)
        errors.append(float(hw.action(t - np.sin(3 * t) / 3, t[1], mass=2.0, **PENDULUM) - exact))
    assert np.divide(errors[:-1], errors[1:]) == pytest.approx([4, 4], rel=1e-2)


@pytest.mark.parametrize("start", [(2.0, 0.5), (-7.0, 9.0)])
def test_the_action_is_stationary_on_motions_alone(start):
    t, small = np.linspace(0, 4, 4001), 1e-3
    motion = hw.simulate(t, *start, **PENDULUM)[:, 0]
    bump = np.sin(np.pi * t / 4) * np.exp(t / 4)
    scale = 2.0 * 1.7 * 9.3 * 4

    def variation(path):
        actions = [hw.action(path + sign * small * bump, t[1], mass=2.0, **PENDULUM) for sign in (1, -1)]
        return (actions[0] - actions[1]) / (2 * small * scale)

    assert abs(variation(motion)) < 1e-5  # (K step)^2 and small^2, both 1e-6 to 1e-5
    assert abs(variation(start[0] + start[1] * t + 0.1 * t**2)) > 1e-2


def energies(states):
    return (states[:, 1] / K) ** 2 / 2 + 2 * np.sin(states[:, 0] / 2) ** 2


STARTS = {
    "tiny": (TINY, 0.0),
    "large": (2.5, 0.3),
    "next to the top": (NEXT_TO_TOP, 0.0),
    "on the separatrix": (0.0, 2 * K),
    "turning": (-0.5, -7.0),
    "turning fast": (40.0, 60.0),
}


def worst_energy(start, duration):
    t = np.cumsum(DRAW.uniform(0.1, 1.9, 1000))
    energy = energies(hw.simulate(t * duration / t[-1], *start, **PENDULUM))
    return np.max(np.abs(energy / energy[0] - 1))


@pytest.mark.parametrize("start", STARTS.values(), ids=STARTS.keys())
def test_the_energy_stays(start):
    assert worst_energy(start, 20 * 2 * math.pi / K) < 1e-11


@pytest.mark.slow
@pytest.mark.parametrize("start", STARTS.values(), ids=STARTS.keys())
def test_the_energy_stays_for_a_thousand_periods(start):
    assert worst_energy(start, 1000 * 2 * math.pi / K) < 1e-11


@pytest.mark.parametrize("start", STARTS.values(), ids=STARTS.keys())
def test_backwards_and_mirrored_it_is_the_same_motion(start):
    """Time reversal and mirror; next to the top the way back magnifies roundings by exp(K t)."""
    t = np.linspace(0.0, 2.0, 7)
    states = hw.simulate(t, *start, **PENDULUM)
    back = hw.simulate(t, states[-1, 0], -states[-1, 1], **PENDULUM)
    tolerance = 1e-11 * max(map(abs, start))
    np.testing.assert_allclose(back[::-1] * [1, -1], states, rtol=0, atol=tolerance)
    np.testing.assert_allclose(
        hw.simulate(t, -start[0], -start[1], **PENDULUM), -states, rtol=0, atol=1e-12 * max(map(abs, start))
    )


def test_the_motion_is_an_elliptic_function():
    """Route: Jacobi's sn in mpmath, swinging from the bottom."""
    omega0, t = 1.3 * K, np.sort(DRAW.uniform(0, 30, 20))
    modulus = mpmath.mpf(omega0) / (2 * mpmath.sqrt(mpmath.mpf(9.3) / mpmath.mpf(1.7)))
    rate = mpmath.sqrt(mpmath.mpf(9.3) / mpmath.mpf(1.7))
    expected = [
        float(2 * mpmath.asin(modulus * mpmath.ellipfun("sn", rate * mpmath.mpf(time), m=modulus**2).real))
        for time in t
    ]
    found = hw.simulate(np.append(0.0, t), 0.0, omega0, **PENDULUM)[1:, 0]
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-11)


def test_the_sampling_changes_nothing_and_the_start_is_kept(monkeypatch):
    # From the top it falls by rounding, and each engine rounds in its own way.
    monkeypatch.setenv("TAM570_COMPILED", "0")
    t = np.cumsum(DRAW.uniform(0.01, 1, 200)) - 5
    for start in STARTS.values():
        many = hw.simulate(t, *start, **PENDULUM)
        assert tuple(many[0]) == start
        few = hw.simulate(t[[0, 50, -1]], *start, **PENDULUM)
        np.testing.assert_allclose(many[[0, 50, -1]], few, rtol=0, atol=1e-10 * np.max(np.abs(few)))


def test_a_whole_number_of_turns_is_a_whole_number_of_turns():
    """Two samples a full turn apart, where every later time folds back to the first."""
    turn = hw._time_of_a_turn(0.3, 9.0, **PENDULUM)
    found = hw.simulate(np.array([1.0, 1.0 + turn]), 0.3, 9.0, **PENDULUM)
    np.testing.assert_allclose(found[1], [0.3 + 2 * math.pi, 9.0], rtol=0, atol=1e-12)


def test_without_gravity_it_turns_uniformly():
    t = np.linspace(-3.0, 1000.0, 50)
    found = hw.simulate(t, 0.3, -4.0, length=1.7, gravity=0.0)
    np.testing.assert_allclose(found, np.column_stack([0.3 - 4.0 * (t + 3), np.full(50, -4.0)]), rtol=1e-13)
    assert np.all(hw.simulate(t, 0.3, 0.0, length=1.7, gravity=0.0) == [0.3, 0.0])


@pytest.mark.parametrize("length", [1e-6, 1e-3, 1e3, 1e6])
@pytest.mark.parametrize("gravity", [1e-6, 1e3])
def test_the_energy_stays_for_rods_of_any_length(length, gravity):
    k = math.sqrt(gravity / length)
    t = np.linspace(5, 5 + 30 / k, 50)
    for start in ((2.5, 0.3 * k), (7.0, -3 * k)):
        theta, omega = hw.simulate(t, *start, length=length, gravity=gravity).T
        energy = (omega / k) ** 2 / 2 + 2 * np.sin(theta / 2) ** 2
        np.testing.assert_allclose(energy / energy[0], 1, rtol=1e-12)
