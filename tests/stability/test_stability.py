"""Where integrators break: rest, symmetry, separatrices, extremes of scale, length, tolerance and sampling."""

import importlib.util
import math
from pathlib import Path

import numpy as np
import pytest

from tam570.integrate import solve, solve_rotation
from tam570.invariants import drift, growth_exponent, rotation_defect

ROOT = Path(__file__).parents[2]
EPS = 2.0**-52
G = 9.81  # m/s^2


def _loaded(path):
    spec = importlib.util.spec_from_file_location(f"_stability_{path.stem}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def pendulum(t, state, *, length):
    return state[1], -G / length * math.sin(state[0])


def pendulum_energy(state):
    """Of length 1 m, from the lowest point; (1 - cos) without its cancellation."""
    return state[1] ** 2 / 2 + 2 * G * math.sin(state[0] / 2) ** 2


def period(amplitude):
    """Of length 1 m, by the arithmetic-geometric mean."""
    a, b = 1.0, math.cos(amplitude / 2)
    while abs(a - b) > EPS * a:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return 2 * math.pi / math.sqrt(G) / a


def oscillator(t, y, *, rate):
    return y[1], -rate * rate * y[0]


SCENES = _loaded(ROOT / "benchmarks" / "run_time" / "scenes.py")


# At rest, at symmetric angles, at zeros of the right-hand side


def double_pendulum(t, state):
    """Two uniform bars of 1 m and 1 kg: tests need one that is not the solution's."""
    a, b, p, q = state
    c, s = math.cos(a - b) / 2, math.sin(a - b) / 2
    f = -s * q * q - 1.5 * G * math.sin(a)
    g = s * p * p - 0.5 * G * math.sin(b)
    d = 4 / 9 - c * c
    return p, q, (f / 3 - c * g) / d, (4 / 3 * g - c * f) / d


def double_pendulum_energy(state):
    a, b, p, q = state
    kinetic = 2 / 3 * p * p + q * q / 6 + math.cos(a - b) * p * q / 2
    return kinetic - G * (1.5 * math.cos(a) + 0.5 * math.cos(b)) + 2 * G


QUARTER = math.pi / 2


@pytest.mark.parametrize(
    "angles", [(QUARTER, QUARTER), (QUARTER, -QUARTER), (math.pi, 0.0), (0.0, QUARTER), (-QUARTER, math.pi)]
)
def test_from_rest_at_symmetric_angles_the_energy_stays(angles):
    t = np.linspace(0, 10, 101)
    states = solve(double_pendulum, t, (*angles, 0.0, 0.0), rtol=1e-12)
    assert drift(double_pendulum_energy, states).max() < 1e-9  # a thousand steps; 0.17 where symmetry deceives


@pytest.mark.parametrize("name", SCENES.SCENES)
def test_the_start_of_every_scene_is_left_by_small_steps(name):
    """Two methods that share nothing but the right-hand side agree."""
    rhs, start, parameters, end = SCENES.scene(name)
    t = np.linspace(0, min(end, 2.0), 5)
    explicit = solve(rhs, t, start, parameters=parameters, rtol=1e-13, method="python")
    implicit = solve(rhs, t, start, parameters=parameters, rtol=1e-12, method="gauss")
    size = np.abs(explicit).max(axis=0) + 1e-300
    assert (np.abs(explicit - implicit) / size).max() < 1e-9


@pytest.mark.parametrize("rest", [[0.0, 0.0], [math.pi, 0.0]])
def test_equilibria_stay(rest):
    states = solve(pendulum, np.linspace(0, 5, 6), rest, parameters={"length": 1.0})
    assert states == pytest.approx(np.tile(rest, (6, 1)), abs=1e-9)  # pi is off by 1e-16, and that grows as exp(3 t)


def test_a_force_that_is_not_there_yet_is_noticed():
    t = np.array([0.0, 4.0, 10.0])
    states = solve(lambda t, y: (math.exp(-((t - 5) ** 2)),), t, [0.0], rtol=1e-12)
    exact = math.sqrt(math.pi) / 2 * (np.array([math.erf(x - 5) for x in t]) + math.erf(5))
    assert states[:, 0] == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize("rate", [0.0, 1e-9])
def test_a_disk_upright_to_the_last_digits_rolls_on(rate):
    """Its tilt is pi/2 rounded: what that does to other rates, one after another, is not to be resolved."""
    hw14 = _loaded(ROOT / "solutions" / "hw14_rolling_disk.py")
    disk = {"mass": 1.0, "radius": 0.5, "inertia": (0.0625, 0.125), "gravity": G}
    calls = []

    def counted(t, state):
        calls.append(float(state[0]))  # asks for a value: called at every stage
        return hw14.euler_state_derivative(t, state, **disk)

    def rolled(tilt_rate):
        calls.clear()
        end = solve(counted, [0, 10], [0, 0, 0, QUARTER, 0, 0, tilt_rate, 8.0], rtol=1e-12)[-1]
        return end, len(calls)

    (end, cost), (wobble, ordinary) = rolled(rate), rolled(1e-3)
    assert cost < 2 * ordinary  # sixty times as many where each rounding is taken for motion
    assert end[[0, 4, 7]] == pytest.approx([-40, 80, 8], rel=1e-10)  # straight on
    if rate == 1e-9:  # small motions are proportional to their start, but for the rounding of the tilt
        assert end[[2, 5]] * 1e6 == pytest.approx(wobble[[2, 5]], abs=1e-5 * abs(wobble[5]))


# Separatrices


def test_along_the_separatrix():
    """sin(theta/2) = tanh(t sqrt(g/l)) from the bottom at the speed that just reaches the top."""
    t = np.linspace(0, 4, 41)  # beyond, exp(3 t) has eaten what rounding left
    states = solve(pendulum, t, [0.0, 2 * math.sqrt(G)], parameters={"length": 1.0}, rtol=1e-14)
    exact = 2 * np.arcsin(np.tanh(t * math.sqrt(G)))
    assert np.abs(states[:, 0] - exact).max() < 1e-9


@pytest.mark.parametrize("below", [1e-2, 1e-5, 1e-8])
def test_started_just_below_the_top_it_takes_the_exact_period(below):
    amplitude = math.pi - below
    T = period(amplitude)
    states = solve(pendulum, [0, T / 4, T], [amplitude, 0.0], parameters={"length": 1.0}, rtol=1e-14)
    assert abs(states[1, 0]) < 1e-12 / below  # the sensitivity of the motion is 1 / below
    assert drift(pendulum_energy, states).max() < 1e-12


def euler(t, omega, *, inertia):
    A, B, C = inertia
    p, q, r = omega
    return (B - C) / A * q * r, (C - A) / B * r * p, (A - B) / C * p * q


def test_flips_of_the_middle_axis():
    inertia = (1.0, 2.0, 3.0)
    t = np.linspace(0, 500, 501)
    omegas, R = solve_rotation(euler, t, [0.0, 1.0, 1e-12], np.eye(3), parameters={"inertia": inertia}, rtol=1e-13)
    assert drift(lambda w: w * w @ inertia, omegas).max() < 1e-11
    momentum = np.einsum("nij,nj->ni", R, omegas * inertia)
    assert np.abs(momentum - momentum[0]).max() < 1e-10
    assert rotation_defect(R).max() < 1e-14
    assert omegas[:, 1].min() < -0.99  # it did flip


# Extremes


@pytest.mark.parametrize("amplitude", [2.0**k for k in (-500, -40, 0, 40, 500)])
def test_a_change_of_units_changes_no_bit(amplitude):
    t = np.linspace(0, 10, 21)
    ones, scaled = (
        solve(oscillator, t, [x, 0.25 * x], parameters={"rate": 2.5}, method="python") for x in (1.0, amplitude)
    )
    assert (scaled == amplitude * ones).all()


@pytest.mark.parametrize("unit", [2.0**k for k in (-40, -20, 20, 40)])
def test_a_change_of_the_second_changes_no_bit(unit):
    t = np.linspace(0, 10, 21)
    seconds = solve(oscillator, t, [1.0, 0.25], parameters={"rate": 2.5}, method="python")
    others = solve(oscillator, t * unit, [1.0, 0.25 / unit], parameters={"rate": 2.5 / unit}, method="python")
    assert (others * [1, unit] == seconds).all()


def test_a_nearly_massless_bar_follows_the_heavy_one():
    hw07 = _loaded(ROOT / "solutions" / "hw07_double_pendulum.py")
    t = np.linspace(0, 5, 11)
    light = hw07.simulate(t, [1.0, 0.3], [0.0, 0.0], masses=(1.0, 1e-12), lengths=(1.0, 1.0), gravity=G)
    alone = solve(pendulum, t, [1.0, 0.0], parameters={"length": 2 / 3}, rtol=1e-12)  # a bar swings as 2/3 of itself
    assert light[:, 0] == pytest.approx(alone[:, 0], abs=1e-9)


def test_a_stiff_decay_costs_steps_but_no_digits():
    rate, t = 1e4, np.array([0.0, 1e-4, 0.01, 1.0])
    states = solve(lambda t, y: (-rate * (y[0] - math.cos(t)) - math.sin(t),), t, [2.0], rtol=1e-10)
    assert states[:, 0] == pytest.approx(np.cos(t) + np.exp(-rate * t), rel=1e-8)


def test_time_runs_back():
    start = [1.2, -0.7, 0.4, 0.9]
    there = solve(double_pendulum, [0, 3.0], start, rtol=1e-14)[-1]
    back = solve(double_pendulum, [0, 3.0], there * [1, 1, -1, -1], rtol=1e-14)[-1] * [1, 1, -1, -1]
    assert back == pytest.approx(start, abs=1e-10)


# Samples and end points


def test_a_sample_every_thousandth_of_a_step_and_one_in_all():
    fine = np.linspace(0, 3, 60001)
    given = {"parameters": {"length": 1.0}, "method": "python"}
    states = solve(pendulum, fine, [2.0, 0.0], **given)
    assert (solve(pendulum, fine[[0, -1]], [2.0, 0.0], **given)[-1] == states[-1]).all()
    jumps = np.abs(np.diff(states, 3, axis=0)).max()
    assert jumps < 1e-9  # no seams between the steps: the third difference itself is 5e-12


def test_two_times_as_close_as_doubles_allow():
    for t0 in (0.0, 1.0, -1e9):
        states = solve(oscillator, [t0, np.nextafter(t0, math.inf)], [1.0, 0.0], parameters={"rate": 1.0})
        assert np.isfinite(states).all()


def switched(t, y):
    """A force that is on until t = 1: the kink lies at an end point, or inside."""
    return y[1], 1.0 if t < 1 else 0.0


def test_events_at_the_end_points_and_inside():
    before = solve(switched, [0, 1.0], [0.0, 0.0])[-1]
    assert before == pytest.approx([0.5, 1.0], abs=1e-9)
    after = solve(switched, [1.0, 3.0], before)[-1]
    assert after == pytest.approx([2.5, 1.0], abs=1e-9)
    across = solve(switched, [0, 0.3, 3.0], [0.0, 0.0])[-1]
    assert across == pytest.approx([2.5, 1.0], abs=1e-8)


def test_a_stop_that_friction_brings_is_found():
    def sliding(t, y):
        return y[1], -2.0 if y[1] > 0 else 0.0

    assert solve(sliding, [0, 5.0], [0.0, 4.0], rtol=1e-8)[-1] == pytest.approx([4.0, 0.0], abs=1e-6)


# Long runs


@pytest.mark.parametrize("method", ["gauss", "composition"])
def test_energy_over_many_periods(method):
    T = period(2.0)
    t = T * np.linspace(0, 100, 201)
    states = solve(pendulum, t, [2.0, 0.0], parameters={"length": 1.0}, method=method, rtol=1e-13)
    assert drift(pendulum_energy, states).max() < 1e-14


@pytest.mark.slow
@pytest.mark.parametrize("method", ["gauss", "composition"])
def test_energy_over_ten_thousand_periods(method):
    """Accumulated rounding, the mean over twelve motions: one random walk alone has no exponent to speak of."""
    errors, share = [], np.geomspace(0.01, 1, 60)
    for amplitude in np.linspace(0.5, 3.0, 12):
        t = np.concatenate([[0.0], 1e4 * period(amplitude) * share])
        states = solve(pendulum, t, [amplitude, 0.0], parameters={"length": 1.0}, method=method, rtol=1e-13)
        errors.append(drift(pendulum_energy, states)[1:])
    assert np.max(errors) < 5e-14
    mean = np.sqrt(np.mean(np.square(errors), axis=0))
    assert growth_exponent(share, mean) < 0.6  # a random walk is 0.5, a drift would be 1


@pytest.mark.slow
@pytest.mark.parametrize("method", ["auto", "gauss", "composition"])
def test_a_hundred_thousand_periods(method):
    T = period(1.0)
    states = solve(pendulum, [0.0, 1e5 * T], [1.0, 0.0], parameters={"length": 1.0}, method=method, rtol=1e-14)
    allowed = {"auto": 1e-8, "gauss": 1e-12, "composition": 1e-12}[method]
    assert drift(pendulum_energy, states).max() < allowed


@pytest.mark.slow
def test_flips_by_the_thousand():
    inertia = (1.0, 2.0, 3.0)
    omegas = solve(euler, np.linspace(0, 5e4, 1001), [0.0, 1.0, 1e-6], parameters={"inertia": inertia}, rtol=1e-15)
    assert drift(lambda w: w * w @ inertia, omegas).max() < 1e-9
