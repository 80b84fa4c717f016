"""Laws of the lecture on Hamilton's principle."""

import math

import numpy as np
import pytest

from tam570.integrate import solve
from tam570.invariants import observed_order
from tam570.lectures.least_action import action, is_minimum, path

SCENE = {"length": 0.8, "gravity": 9.81}
HALF = math.pi * math.sqrt(0.8 / 9.81)  # s, half a period of a small swing


def swing(theta, omega, duration, points):
    """Return the angles of the solved motion."""
    times = np.linspace(0.0, duration, points)
    return solve(lambda t, y: (y[1], -9.81 / 0.8 * math.sin(y[0])), times, [theta, omega], rtol=1e-12)[:, 0]


@pytest.mark.parametrize(("share", "omega"), [(0.4, 3.0), (0.8, -2.0), (0.98, 0.5)])
def test_it_meets_the_solved_motion_to_second_order(share, omega):
    duration, counts, errors = share * HALF, (21, 41, 81, 161), []
    for points in counts:
        solved = swing(0.3, omega, duration, points)
        result = path(solved[0], solved[-1], duration, points=points, **SCENE)
        assert result.shape == (points,) and (result[0], result[-1]) == (solved[0], solved[-1])
        errors.append(np.abs(result - solved).max())
    assert observed_order([1 / (n - 1) for n in counts], errors) == pytest.approx(2.0, abs=0.1)


def test_every_neighbour_has_more_action():
    result = path(-0.5, 1.0, 0.9 * HALF, points=61, **SCENE)
    least, s = action(result, 0.9 * HALF, **SCENE), np.linspace(0, 1, 61)
    for waves in (1, 2, 5):
        for size in (-0.1, -1e-3, 1e-3, 0.1):
            assert action(result + size * np.sin(waves * math.pi * s), 0.9 * HALF, **SCENE) > least


def test_the_action_is_kinetic_less_potential_over_time():
    """The action of rest is -V T with V = -g l cos; that of a constant rate without gravity is l^2 th'^2/2 T."""
    assert action(np.full(5, 0.4), 2.0, **SCENE) == pytest.approx(2.0 * 9.81 * 0.8 * math.cos(0.4))
    assert action(np.linspace(0, 1, 9), 2.0, length=0.8, gravity=0.0) == pytest.approx(0.8**2 / 2 * 0.25 * 2.0)


@pytest.mark.parametrize(("share", "least"), [(0.5, True), (0.99, True), (1.01, False), (1.7, False)])
def test_small_swings_are_minima_before_half_a_period_alone(share, least):
    assert is_minimum(swing(0.0, 0.05, share * HALF, 201), share * HALF, **SCENE) is least


def test_what_is_no_motion_is_no_minimum():
    assert is_minimum(np.zeros(41), 0.5 * HALF, **SCENE)
    for points in (3, 5, 401):
        assert is_minimum(path(0.0, 0.0, 0.9 * HALF, points=points, **SCENE), 0.9 * HALF, **SCENE)
    assert not is_minimum(0.3 * np.linspace(0, 1, 41), 0.5 * HALF, **SCENE)


@pytest.mark.parametrize("share", [0.999, 1.0, 1.001, 1.3, 2.5])
def test_past_half_a_period_another_motion_has_less(share):
    """`path` obeys the equation of motion, and past half a period it has less action than rest."""
    duration, points = share * HALF, 401
    result = path(0.0, 0.0, duration, points=points, **SCENE)
    h = duration / (points - 1)
    assert np.abs(np.diff(result, 2) / h**2 + 9.81 / 0.8 * np.sin(result[1:-1])).max() < 1e-4  # 1e-11/h^2
    below = action(result, duration, **SCENE) - action(np.zeros(points), duration, **SCENE)
    assert below < -1e-9 if share > 1 else abs(below) < 1e-9
    assert is_minimum(result, duration, **SCENE) or share == 1.0
