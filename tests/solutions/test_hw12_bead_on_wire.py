"""hw12: the reference against 50 digits of mpmath, against SymPy, and against its own laws."""

import math

import mpmath
import numpy as np
import pytest
import sympy

from tam570_grader.checks import assignments

hw = assignments.solution("hw12_bead_on_wire")
DRAW = np.random.default_rng(1)
WIRE = {"curvature": 0.37, "gravity": 9.3}  # 1/m, m/s^2
RATE = math.sqrt(2 * 0.37 * 9.3)  # 1/s, of small motions
ROUNDINGS = 1e-13  # relative, of a closed form
STEEPNESS = [1e-8, 1e-5, 1e-3, 0.1, 0.5, 1.0, 10.0, 1e3, 1e4]  # curvature times amplitude


@pytest.fixture(autouse=True)
def fifty_digits():
    with mpmath.workdps(50):
        yield


def states(number):
    """x, v, mass, curvature, gravity over many decades."""
    for _ in range(number):
        c, g = 10 ** DRAW.uniform(-6, 6), DRAW.uniform(1, 30) * DRAW.choice([0, 1], p=[0.2, 0.8])
        x = DRAW.choice([-1, 1]) * 10 ** DRAW.uniform(-8, 4) / c
        yield x, DRAW.normal() * math.sqrt(10 / c), 10 ** DRAW.uniform(-6, 6), c, g


def test_acceleration_and_force_are_those_of_constrained_motion():
    """Route: the linear system for x'', y'' and the multiplier of y - c x^2 = 0, in mpmath."""
    for x, v, m, c, g in states(40):
        X, V, M, C, G = map(mpmath.mpf, (x, v, m, c, g))
        system = mpmath.matrix([[M, 0, 2 * C * X], [0, M, -1], [-2 * C * X, 1, 0]])
        ax, _, multiplier = mpmath.lu_solve(system, mpmath.matrix([0, -M * G, 2 * C * V**2]))
        found = hw.acceleration_newton(x, v, curvature=c, gravity=g)
        assert abs(found - ax) <= ROUNDINGS * abs(ax)
        force = hw.constraint_force(x, v, mass=m, curvature=c, gravity=g)
        assert abs(force[0] + 2 * C * X * multiplier) <= ROUNDINGS * abs(2 * C * X * multiplier)
        assert abs(force[1] - multiplier) <= ROUNDINGS * abs(multiplier)


def test_the_energy_is_that_of_velocity_and_height():
    for x, v, m, c, g in states(40):
        X, V, M, C, G = map(mpmath.mpf, (x, v, m, c, g))
        expected = M * (V**2 + (2 * C * X * V) ** 2) / 2 + M * G * C * X**2
        assert abs(hw.energy(x, v, mass=m, curvature=c, gravity=g) - expected) <= ROUNDINGS * expected
    assert hw.energy(0.0, 0.0, mass=2.0, **WIRE) == 0


def test_the_power_of_all_forces_is_the_rate_of_the_energy():
    """dE/dt = 0 pins x'': derivatives of the energy by SymPy."""
    x, v, m, c, g = sympy.symbols("x v m c g")
    energy = m * (1 + 4 * c**2 * x**2) * v**2 / 2 + m * g * c * x**2
    rate = energy.diff(x) * v + energy.diff(v) * hw.lagrange_equation()
    assert sympy.simplify(rate) == 0


def test_the_formulas_are_those_of_lagrange_and_newton():
    """Route: SymPy differentiates along an unknown function of time."""
    t, x, v = sympy.symbols("t x v")
    place = sympy.Function("place")(t)
    along = hw.lagrangian().subs({v: place.diff(t), x: place})
    equation = along.diff(place.diff(t)).diff(t) - along.diff(place)
    motion = hw.lagrange_equation().subs({v: place.diff(t), x: place})
    assert sympy.simplify(equation.subs(place.diff(t, 2), motion)) == 0
    assert {symbol.name for symbol in hw.lagrange_equation().free_symbols} == {"x", "v", "c", "g"}
    number = hw.lagrange_equation().subs({x: 0.7, v: -1.5, "c": 0.37, "g": 9.3})
    assert float(number) == pytest.approx(hw.acceleration_newton(0.7, -1.5, **WIRE), rel=ROUNDINGS)


@pytest.mark.parametrize("steepness", STEEPNESS)
def test_the_period_is_an_elliptic_integral(steepness):
    """Route: Legendre's E in mpmath."""
    amplitude = steepness / 0.37
    c, g = mpmath.mpf(0.37), mpmath.mpf(9.3)
    expected = 4 * mpmath.ellipe(-((2 * c * mpmath.mpf(amplitude)) ** 2)) / mpmath.sqrt(2 * g * c)
    assert abs(hw.period(amplitude, **WIRE) / expected - 1) < ROUNDINGS


def test_the_period_has_the_known_limits():
    """1 + (cA)^2 for small amplitudes; up and down a wall, twice, for huge ones."""
    for steepness in (1e-3, 1e-2):
        swing = hw.period(steepness / 0.37, **WIRE) * RATE / (2 * math.pi)
        assert swing == pytest.approx(1 + steepness**2, abs=1e-15 + steepness**4)
    amplitude = 1e4 / 0.37
    fall = math.sqrt(2 * 0.37 * amplitude**2 / 9.3)  # time of a free fall from that height
    assert hw.period(amplitude, **WIRE) == pytest.approx(4 * fall, rel=1e-6)


def test_only_curvature_times_amplitude_counts():
    for steepness in STEEPNESS:
        swings = [
            hw.period(steepness / c, curvature=c, gravity=g) * math.sqrt(2 * g * c) for c, g in ((0.01, 3), (70, 20))
        ]
        assert swings[0] == pytest.approx(swings[1], rel=ROUNDINGS)


def starts(steepness):
    """At rest at the amplitude, and on the way."""
    amplitude = steepness / 0.37
    x = -0.6 * amplitude
    return [(amplitude, 0.0), (x, 0.8 * amplitude * RATE / math.hypot(1, 2 * 0.37 * x))]


def worst_energy(steepness, periods, rows):
    worst = 0.0
    for start in starts(steepness):
        t = np.cumsum(DRAW.uniform(0.1, 1.9, rows)) - 3
        t *= periods * hw.period(steepness / 0.37, **WIRE) / t[-1]
        energy = hw.energy(*hw.simulate(t, *start, **WIRE).T, mass=1.0, **WIRE)
        worst = max(worst, np.max(np.abs(energy / energy[0] - 1)))
    return worst


@pytest.mark.parametrize("steepness", STEEPNESS)
def test_the_energy_stays(steepness):
    assert worst_energy(steepness, 5, 200) < 1e-11


@pytest.mark.slow
@pytest.mark.parametrize("steepness", STEEPNESS)
def test_the_energy_stays_for_a_thousand_periods(steepness):
    assert worst_energy(steepness, 1000, 2000) < 1e-11


@pytest.mark.parametrize("steepness", [1e-3, 1.0, 10.0])
def test_the_motion_is_an_elliptic_function(steepness):
    """Route: E(phi) grows evenly for x = A sin phi; the root phi in mpmath."""
    amplitude = steepness / 0.37
    c, g, A = mpmath.mpf(0.37), mpmath.mpf(9.3), mpmath.mpf(amplitude)
    m = -((2 * c * A) ** 2)
    t = np.array([0.0, 0.3, 0.9]) * hw.period(amplitude, **WIRE)
    found = hw.simulate(t, amplitude, 0.0, **WIRE)
    for time, (x, v) in zip(t[1:], found[1:], strict=True):
        grown = mpmath.ellipe(m) + mpmath.sqrt(2 * g * c) * mpmath.mpf(time)
        quarter = mpmath.floor(grown / mpmath.ellipe(m)) * mpmath.pi / 2
        phi = mpmath.findroot(
            lambda p, s=grown: mpmath.ellipe(p, m) - s, (quarter, quarter + mpmath.pi / 2), "anderson"
        )
        rate = mpmath.sqrt(2 * g * c) / mpmath.sqrt(1 - m * mpmath.sin(phi) ** 2)
        assert abs(x - A * mpmath.sin(phi)) < 1e-12 * A
        assert abs(v - A * mpmath.cos(phi) * rate) < 1e-12 * A * mpmath.sqrt(2 * g * c)


def test_the_sampling_changes_nothing_and_the_start_is_kept():
    t = np.cumsum(DRAW.uniform(0.01, 0.3, 200)) - 5
    for steepness in (1e-3, 1.0, 50.0):
        for start in starts(steepness):
            many = hw.simulate(t, *start, **WIRE)
            assert tuple(many[0]) == start
            few = hw.simulate(t[[0, 50, -1]], *start, **WIRE)
            np.testing.assert_allclose(many[[0, 50, -1]], few, rtol=0, atol=1e-11 * np.max(np.abs(many)))


def test_backwards_and_mirrored_it_is_the_same_motion():
    t = np.linspace(0.0, 4.0, 9)
    for start in starts(2.0):
        motion = hw.simulate(t, *start, **WIRE)
        back = hw.simulate(t, motion[-1, 0], -motion[-1, 1], **WIRE)
        np.testing.assert_allclose(back[::-1] * [1, -1], motion, rtol=0, atol=1e-11)
        np.testing.assert_allclose(hw.simulate(t, -start[0], -start[1], **WIRE), -motion, rtol=0, atol=1e-12)


def test_without_gravity_it_goes_along_the_wire_at_its_speed():
    t, c = np.linspace(-2.0, 9.0, 20), 0.37
    x, v = hw.simulate(t, -1.3, 0.9, curvature=c, gravity=0.0).T
    u = 2 * c * x
    arc = (u * np.hypot(1, u) + np.arcsinh(u)) / (4 * c)
    speed = 0.9 * math.hypot(1, 2 * c * 1.3)
    np.testing.assert_allclose(arc - arc[0], speed * (t + 2), rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(v * np.hypot(1, u), speed, rtol=1e-12)


@pytest.mark.parametrize("curvature", [1e-6, 1e-3, 1e3, 1e6])
@pytest.mark.parametrize("gravity", [1e-6, 1e3])
def test_wires_of_any_size_bring_the_bead_back_after_three_periods(curvature, gravity):
    wire = {"curvature": curvature, "gravity": gravity}
    for steepness in (1e-8, 1.0, 1e4):
        amplitude = steepness / curvature
        t = np.linspace(5, 5 + 3 * hw.period(amplitude, **wire), 20)
        motion = hw.simulate(t, amplitude, 0.0, **wire)
        assert motion[-1, 0] == pytest.approx(amplitude, rel=1e-12)
        energy = hw.energy(*motion.T, mass=2.0, **wire)
        np.testing.assert_allclose(energy / energy[0], 1, rtol=1e-12)
