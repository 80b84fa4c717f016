"""Where integrators break: rest, symmetry, separatrices, extremes of scale, length, tolerance and sampling."""

import importlib.util
import math
from pathlib import Path

import numpy as np
import pytest

from tam570.integrate import solve
from tam570.invariants import drift, growth_exponent

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


@pytest.mark.parametrize("name", SCENES.SCENES)
def test_the_start_of_every_scene_is_left_by_small_steps(name):
    """Two methods that share nothing but the right-hand side agree."""
    rhs, start, parameters, end = SCENES.scene(name)
    t = np.linspace(0, min(end, 2.0), 5)
    explicit = solve(rhs, t, start, parameters=parameters, rtol=1e-13, method="python")
    implicit = solve(rhs, t, start, parameters=parameters, rtol=1e-12, method="gauss")
    size = np.abs(explicit).max(axis=0) + 1e-300
    assert (np.abs(explicit - implicit) / size).max() < 1e-9


def test_a_force_that_is_not_there_yet_is_noticed():
    t = np.array([0.0, 4.0, 10.0])
    states = solve(lambda t, y: (math.exp(-((t - 5) ** 2)),), t, [0.0], rtol=1e-12)
    exact = math.sqrt(math.pi) / 2 * (np.array([math.erf(x - 5) for x in t]) + math.erf(5))
    assert states[:, 0] == pytest.approx(exact, rel=1e-9)


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


def test_a_stiff_decay_costs_steps_but_no_digits():
    rate, t = 1e4, np.array([0.0, 1e-4, 0.01, 1.0])
    states = solve(lambda t, y: (-rate * (y[0] - math.cos(t)) - math.sin(t),), t, [2.0], rtol=1e-10)
    assert states[:, 0] == pytest.approx(np.cos(t) + np.exp(-rate * t), rel=1e-8)


def test_two_times_as_close_as_doubles_allow():
    for t0 in (0.0, 1.0, -1e9):
        states = solve(oscillator, [t0, np.nextafter(t0, math.inf)], [1.0, 0.0], parameters={"rate": 1.0})
        assert np.isfinite(states).all()


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
