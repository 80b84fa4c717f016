"""Where integrators break: rest, symmetry, separatrices, extremes of scale, length, tolerance and sampling."""

import math
import runpy

import numpy as np
import pytest
from systems import EPS

from tam570.integrate import solve
from tam570.invariants import drift, growth_exponent
from tam570_grader.checks import assignments

G = 9.81  # m/s^2


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


BENCHMARK = runpy.run_path(str(assignments.find() / "benchmarks" / "run_time" / "scenes.py"))


@pytest.mark.parametrize("name", BENCHMARK["SCENES"])
def test_the_start_of_every_scene_is_left_by_small_steps(name):
    """Two methods that share nothing but the right-hand side agree."""
    rhs, start, parameters, end = BENCHMARK["scene"](name)
    t = np.linspace(0, min(end, 2.0), 5)
    explicit = solve(rhs, t, start, parameters=parameters, rtol=1e-13, method="python")
    implicit = solve(rhs, t, start, parameters=parameters, rtol=1e-12, method="gauss")
    size = np.abs(explicit).max(axis=0) + 1e-300
    assert (np.abs(explicit - implicit) / size).max() < 1e-9


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


def test_two_times_as_close_as_doubles_allow():
    for t0 in (0.0, 1.0, -1e9):
        states = solve(oscillator, [t0, np.nextafter(t0, math.inf)], [1.0, 0.0], parameters={"rate": 1.0})
        assert np.isfinite(states).all()


@pytest.mark.parametrize("amplitude", [0.3, 0.7, 1.0, 1.3])
def test_rounding_makes_no_energy_drift(amplitude):
    """A random walk of half a million steps comes to 1e-13; a third that is rounded the same way each time to 3e-12."""
    turns = [0.0, 2e5 * math.pi]
    _, (x, v) = solve(oscillator, turns, [amplitude, 0.0], parameters={"rate": 1.0}, rtol=1e-15, method="compiled")
    assert x * x + v * v == pytest.approx(amplitude**2, rel=4e-13, abs=0)


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
