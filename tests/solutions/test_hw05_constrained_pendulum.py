"""hw05: the reference against 50 digits of mpmath, elliptic functions, SymPy, and its own laws."""

import math

import mpmath
import numpy as np
import pytest
import sympy

from tam570_grader.checks import assignments

hw = assignments.solution("hw05_constrained_pendulum")
DRAW = np.random.default_rng(5)
PENDULUM = {"mass": 2.3, "length": 1.7, "gravity": 9.3}  # kg, m, m/s^2
ROUNDINGS = 1e-13  # relative to the largest term
LENGTHS = (1e-3, 1.7, 1e3)  # m


@pytest.fixture(autouse=True)
def fifty_digits():
    with mpmath.workdps(50):
        yield


def pendulums(number):
    """Masses and lengths over twelve decades, with and without gravity."""
    return [
        {
            "mass": 10 ** DRAW.uniform(-6, 6),
            "length": 10 ** DRAW.uniform(-6, 6),
            "gravity": DRAW.uniform(1, 30) * (i % 3 > 0),
        }
        for i in range(number)
    ]


def on_circle(theta, omega, length):
    """The state at an angle from straight down."""
    c, s = math.cos(theta), math.sin(theta)
    return length * np.array([s, -c, omega * c, omega * s])


def random_state(known):
    rate = math.sqrt((known["gravity"] or 1.0) / known["length"])
    return on_circle(DRAW.uniform(-4, 4), DRAW.normal() * rate, known["length"])


def size(state, known):
    """The size of an acceleration."""
    return state[2:] @ state[2:] / known["length"] + known["gravity"]


@pytest.mark.parametrize("known", pendulums(12))
def test_force_and_acceleration_have_full_digits(known):
    """Route: the linear system of F = m a and r . a + v . v = 0, solved in mpmath.

    The state is on the circle but for roundings, which move the solution by as much.
    """
    state = random_state(known)
    m, g = (mpmath.mpf(known[name]) for name in ("mass", "gravity"))
    x, y, vx, vy = (mpmath.mpf(q) for q in state)
    system = mpmath.matrix([[m, 0, -x], [0, m, -y], [x, y, 0]])
    ax, ay, pull = mpmath.lu_solve(system, mpmath.matrix([0, -m * g, -(vx**2) - vy**2]))
    for found, expected in zip(hw.acceleration(state, **known), (ax, ay), strict=True):
        assert abs(found - expected) <= ROUNDINGS * size(state, known)
    for found, expected in zip(hw.constraint_force(state, **known), (pull * x, pull * y), strict=True):
        assert abs(found - expected) <= ROUNDINGS * known["mass"] * size(state, known)


def test_the_force_comes_from_the_constraint_differentiated_twice():
    """Route: SymPy differentiates x^2 + y^2 along unknown functions of time."""
    t, m, g, pull = sympy.symbols("t m g N")
    x, y = (sympy.Function(name)(t) for name in "xy")
    constraint = (x**2 + y**2).diff(t, 2).subs({x.diff(t, 2): pull * x / m, y.diff(t, 2): pull * y / m - g})
    solved = sympy.solve(constraint, pull)[0]
    symbols = sympy.symbols("x y vx vy")
    solved = solved.subs({x.diff(t): symbols[2], y.diff(t): symbols[3]}).subs({x: symbols[0], y: symbols[1]})
    function = sympy.lambdify((*symbols, m, g), solved)
    for _ in range(10):
        state = random_state(PENDULUM)
        expected = function(*state, PENDULUM["mass"], PENDULUM["gravity"]) * state[:2]
        np.testing.assert_allclose(hw.constraint_force(state, **PENDULUM), expected, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("known", pendulums(6))
def test_the_constraint_force_is_radial_and_does_no_work(known):
    state = random_state(known)
    force, scale = hw.constraint_force(state, **known), known["mass"] * size(state, known)
    assert abs(force[0] * state[1] - force[1] * state[0]) <= 1e-15 * scale * known["length"]
    assert abs(force @ state[2:]) <= 1e-15 * scale * np.linalg.norm(state[2:])
    total = force / known["mass"] - [0, known["gravity"]]
    np.testing.assert_allclose(hw.acceleration(state, **known), total, rtol=0, atol=1e-15 * size(state, known) * 4)


def test_a_consistent_state_is_the_nearest():
    """Route: projections in mpmath; no point of the circle is nearer, no tangent velocity either."""
    for length in 10.0 ** DRAW.uniform(-6, 6, 12):
        state = DRAW.normal(size=4) * 10 ** DRAW.uniform(-6, 6, 4)
        x, y, vx, vy = (mpmath.mpf(q) for q in state)
        d = mpmath.hypot(x, y)
        across = (x * vy - y * vx) / d**2
        expected = (x / d * length, y / d * length, -across * y, across * x)
        scales = [length, length, math.hypot(*state[2:]), math.hypot(*state[2:])]
        found = hw.consistent_state(state, length=length)
        for one, value, scale in zip(found, expected, scales, strict=True):
            assert abs(one - value) <= 1e-15 * scale * 4
        again = hw.consistent_state(found, length=length)
        np.testing.assert_allclose(again / scales, found / scales, rtol=0, atol=4e-15)
    with pytest.raises(ValueError, match="origin"):
        hw.consistent_state(np.array([0.0, -0.0, 1.0, 2.0]), length=1.0)


def test_the_energy_changes_by_no_more_than_rounding_along_the_acceleration():
    """Route: dE/dt = m v . a + m g v_y, a complex step along the motion."""
    for known in pendulums(6):
        state, step = random_state(known), 1e-30
        rates = np.append(state[2:], hw.acceleration(state, **known))
        power = hw.energy(state + 1j * step * rates, mass=known["mass"], gravity=known["gravity"]).imag / step
        assert abs(power) <= 1e-14 * known["mass"] * size(state, known) * np.linalg.norm(state[2:])


STARTS = {
    "small": (1e-3, 0.0),
    "swinging": (2.0, 0.3),
    "nearly to the top": (math.pi - 1e-6, 0.0),
    "turning": (-0.5, -2.3),
    "turning fast": (3.0, 30.0),
}  # rad, and the rate in sqrt(g/l)


def long_run(start, length, duration, gravity=9.3):
    """Times, states and the state's scale of speed for a run from a start."""
    rate = math.sqrt((gravity or 1.0) / length)
    state = on_circle(start[0], start[1] * rate, length)
    t = np.cumsum(DRAW.uniform(0.1, 1.9, 500))
    t = 3.0 + (t - t[0]) * duration / (t[-1] - t[0])
    return t, hw.simulate(t, state, mass=2.3, length=length, gravity=gravity)


def judge(states, length, gravity):
    """On the circle and tangent to it to 1e-12, with the energy of the start to 1e-11."""
    x, y, vx, vy = states.T
    assert np.max(np.abs(x**2 + y**2 - length**2)) <= 1e-12 * length**2
    assert np.max(np.abs(x * vx + y * vy)) <= 1e-12 * length * np.max(np.hypot(vx, vy))
    energies = np.array([hw.energy(state, mass=1.0, gravity=gravity) for state in states])
    assert np.max(np.abs(energies - energies[0])) <= 1e-11 * (gravity * length + np.max(vx**2 + vy**2))


@pytest.mark.parametrize("length", LENGTHS)
@pytest.mark.parametrize("start", STARTS.values(), ids=STARTS.keys())
def test_it_stays_on_the_circle_and_keeps_its_energy(start, length):
    periods = 30
    _, states = long_run(start, length, periods * 2 * math.pi * math.sqrt(length / 9.3))
    judge(states, length, 9.3)


@pytest.mark.slow
@pytest.mark.parametrize("length", [1.7, 1e3])
@pytest.mark.parametrize("start", STARTS.values(), ids=STARTS.keys())
def test_it_stays_so_for_ten_thousand_seconds(start, length):
    _, states = long_run(start, length, 1e4)
    judge(states, length, 9.3)


@pytest.mark.slow
def test_it_stays_so_even_at_a_length_of_a_millimetre():
    """More than a hundred thousand swings."""
    _, states = long_run(STARTS["swinging"], 1e-3, 1e4)
    judge(states, 1e-3, 9.3)


@pytest.mark.parametrize("length", LENGTHS)
def test_without_gravity_it_goes_round_uniformly(length):
    t, states = long_run((0.3, 2.0), length, 100 * math.sqrt(length), gravity=0.0)
    omega = 2.0 / math.sqrt(length)
    angle = 0.3 + omega * (t - t[0])
    expected = np.array([on_circle(one, omega, length) for one in angle])
    scale = length * np.repeat([1.0, omega], 2)
    np.testing.assert_allclose(states / scale, expected / scale, rtol=0, atol=1e-12 + 1e-15 * 200)


def test_the_motion_is_an_elliptic_function():
    """Route: Jacobi's functions in mpmath, swinging and turning, from the bottom."""
    length, rate = mpmath.mpf(1.7), mpmath.sqrt(mpmath.mpf(9.3) / mpmath.mpf(1.7))
    t = np.append(0.0, np.sort(DRAW.uniform(0, 20, 12)))
    for omega in (3.0, 7.0):
        m = (omega / (2 * rate)) ** 2
        start = np.array([0.0, -1.7, 1.7 * omega, 0.0])
        found = hw.simulate(t, start, **PENDULUM)
        for row, time in zip(found, t, strict=True):
            if m < 1:
                half = mpmath.asin(mpmath.sqrt(m) * mpmath.ellipfun("sn", rate * time, m=m).real)
                turning = omega * mpmath.ellipfun("cn", rate * time, m=m).real
            else:
                u = omega / 2 * mpmath.mpf(time)
                sn, cn, dn = (mpmath.ellipfun(name, u, m=1 / m).real for name in ("sn", "cn", "dn"))
                half, turning = mpmath.atan2(sn, cn), omega * dn
            s, c = mpmath.sin(2 * half), mpmath.cos(2 * half)
            expected = [float(length * q) for q in (s, -c, turning * c, turning * s)]
            np.testing.assert_allclose(row, expected, rtol=0, atol=2e-11)


@pytest.mark.parametrize("length", LENGTHS)
def test_at_the_very_top_it_stays(length):
    top = np.array([0.0, length, 0.0, 0.0])
    assert np.all(hw.acceleration(top, mass=2.3, length=length, gravity=9.3) == 0)
    states = hw.simulate(np.array([0.0, 1.0, 100.0, 1e4]), top, mass=2.3, length=length, gravity=9.3)
    assert np.all(states == top)


def test_next_to_the_top_it_falls_as_the_linear_equation_says():
    """Limit: x grows as cosh(sqrt(g/l) t) while x^3 is nothing."""
    rate = math.sqrt(9.3 / 1.7)
    t = np.linspace(0, 3, 7)
    x = hw.simulate(t, 1.7 * np.array([1e-6, 1.0 - 5e-13, 0, 0]), **PENDULUM)[:, 0]
    np.testing.assert_allclose(x, 1.7e-6 * np.cosh(rate * t), rtol=1e-5)


@pytest.mark.parametrize("start", STARTS.values(), ids=STARTS.keys())
def test_sampling_mirror_and_time_reversal(start):
    """The way back from next to the top magnifies roundings by exp(t sqrt(g/l)); 3 s of it."""
    rate = math.sqrt(9.3 / 1.7)
    state = on_circle(start[0], start[1] * rate, 1.7)
    t, turn, mirror = np.array([-2.0, -1.7, 0.1, 1.0]), np.array([1, 1, -1, -1]), np.array([-1, 1, -1, 1])
    states = hw.simulate(t, state, **PENDULUM)
    assert np.all(states[0] == state)
    tolerance = 1e-10 * np.max(np.abs(states))
    few = hw.simulate(t[[0, -1]], state, **PENDULUM)
    np.testing.assert_allclose(few, states[[0, -1]], rtol=0, atol=tolerance)
    back = hw.simulate(-t[::-1], states[-1] * turn, **PENDULUM)
    np.testing.assert_allclose(back[::-1] * turn, states, rtol=0, atol=tolerance)
    mirrored = hw.simulate(t, state * mirror, **PENDULUM)
    np.testing.assert_allclose(mirrored, states * mirror, rtol=0, atol=tolerance)


def test_the_rod_is_one_segment():
    state = random_state(PENDULUM)
    assert hw.wireframe(state, length=1.7).tolist() == [[[0.0, 0.0], state[:2].tolist()]]
