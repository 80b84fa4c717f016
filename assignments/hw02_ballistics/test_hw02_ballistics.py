"""Visible tests of hw02: run them with `tam570 check hw02` (or plain pytest) as often as you like."""

import math
from functools import partial

import hw02_ballistics as hw
import numpy as np
import pytest
from matplotlib.figure import Figure

from tam570.checking.drawings import curves, in_metres

BALL = {"mass": 2.0, "drag": 0.5, "gravity": 9.81}  # kg, kg/s, m/s^2
VACUUM = {**BALL, "drag": 0.0}
SPEED, ANGLE = 30.0, 0.8  # m/s, rad
T = np.linspace(0.0, 6.0, 61)  # s
numbers = partial(np.asarray, dtype=float)  # of a result, whatever kind of numbers or lists it came as


def test_two_forces_act_on_a_particle_that_flies():
    forces = hw.free_body_diagram(np.array([1.0, 2.0, 3.0, -4.0]), mass=2.0, drag=0.5, gravity=10.0)
    assert len(forces) == 2
    for point, _ in forces:
        np.testing.assert_allclose(numbers(point), [1.0, 2.0])


def test_a_particle_at_rest_starts_to_fall():
    rates = numbers(hw.state_derivative(0.0, np.zeros(4), **BALL))
    np.testing.assert_allclose(rates, [0, 0, 0, -9.81], atol=1e-12)


def test_drag_is_against_the_velocity():
    rates = numbers(hw.state_derivative(0.0, np.array([0.0, 0.0, 4.0, -8.0]), **BALL))
    np.testing.assert_allclose(rates, [4.0, -8.0, -1.0, 2.0 - 9.81], atol=1e-12)


def test_it_starts_at_the_origin():
    start = [0.0, 0.0, SPEED * math.cos(ANGLE), SPEED * math.sin(ANGLE)]
    np.testing.assert_allclose(numbers(hw.simulate(T, SPEED, ANGLE, **BALL))[0], start, atol=1e-12)
    np.testing.assert_allclose(numbers(hw.trajectory(T, SPEED, ANGLE, **BALL))[0], start, atol=1e-12)


def test_simulation_and_closed_form_agree():
    simulated, closed = hw.simulate(T, SPEED, ANGLE, **BALL), hw.trajectory(T, SPEED, ANGLE, **BALL)
    np.testing.assert_allclose(numbers(simulated), numbers(closed), atol=1e-5)


def test_the_closed_form_obeys_the_equations_of_motion():
    h = 1e-4
    early, now, late = numbers(hw.trajectory(np.array([1.0 - h, 1.0, 1.0 + h]), SPEED, ANGLE, **BALL))
    rates = numbers(hw.state_derivative(1.0, now, **BALL))
    np.testing.assert_allclose((late - early) / (2 * h), rates, rtol=1e-6)


def test_without_drag_it_is_a_parabola():
    x, y, _, _ = numbers(hw.trajectory(T, SPEED, ANGLE, **VACUUM)).T
    np.testing.assert_allclose(y, x * math.tan(ANGLE) - 9.81 * (x / (SPEED * math.cos(ANGLE))) ** 2 / 2, atol=1e-9)
    way = float(hw.horizontal_range(SPEED, ANGLE, **VACUUM))
    assert way == pytest.approx(SPEED**2 * math.sin(2 * ANGLE) / 9.81)


def test_it_is_back_at_launch_height_at_the_flight_time():
    time = float(hw.flight_time(SPEED, ANGLE, **BALL))
    x, y, _, _ = numbers(hw.trajectory(np.array([0.0, time]), SPEED, ANGLE, **BALL))[1]
    assert time > 0
    assert y == pytest.approx(0.0, abs=1e-6)
    assert x == pytest.approx(float(hw.horizontal_range(SPEED, ANGLE, **BALL)))


def test_no_angle_near_the_best_one_goes_further():
    best = float(hw.best_angle(SPEED, **BALL))
    ranges = [float(hw.horizontal_range(SPEED, best + off, **BALL)) for off in (-0.01, 0.0, 0.01)]
    assert max(ranges) == ranges[1]


def test_the_limit_shape_begins_at_the_launch():
    corners = numbers(hw.limit_shape(ANGLE))
    assert corners.shape == (3, 2)
    np.testing.assert_allclose(corners[0], [0, 0], atol=1e-12)


def test_two_curves_are_drawn():
    axes = Figure().subplots()
    hw.plot_comparison(axes, np.linspace(0.0, 6.0, 201), SPEED, ANGLE, **BALL)
    assert len(curves(axes)) == 2
    assert in_metres(axes.get_xlabel()) and in_metres(axes.get_ylabel())
