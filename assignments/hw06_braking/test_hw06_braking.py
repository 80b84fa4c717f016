"""Visible tests of hw06: run them with `tam570 check hw06` (or plain pytest) as often as you like."""

import math
from functools import partial

import hw06_braking as hw
import numpy as np
import pytest

LENGTHS = {"front": 1.0, "rear": 1.5}  # m
BODY = {"mass": 1200.0, "yaw_inertia": 1500.0, **LENGTHS}  # kg, kg m^2
ROAD = {"friction": 0.8, "gravity": 9.8}
WEIGHT = 1200.0 * 9.8  # N
STRAIGHT = np.array([0.0, 0.0, 0.3, 20.0, 0.0])
REST = np.array([1.0, 2.0, 0.3, 0.0, 0.0])
numbers = partial(np.asarray, dtype=float)  # of a result, whatever kind of numbers or lists it came as


def force(state, locked):
    return numbers(hw.friction_force(state, locked, mass=1200.0, **LENGTHS, **ROAD))


def test_the_ground_pushes_the_car_at_its_axles():
    car = {"mass": 1000.0, "front": 1.0, "rear": 2.0, "friction": 0.8, "gravity": 10.0}
    for locked in ("front", "rear"):
        forces = hw.free_body_diagram(np.array([5.0, 6.0, 0.0, 20.0, 0.3]), locked, **car)
        np.testing.assert_allclose(sorted(float(point[0]) for point, _ in forces), [3.0, 6.0])


def test_the_two_axles_carry_the_weight_and_the_one_near_G_carries_more():
    front, rear = (float(hw.axle_load(locked, mass=1200.0, gravity=9.8, **LENGTHS)) for locked in ("front", "rear"))
    assert front + rear == pytest.approx(WEIGHT)
    assert front > rear


@pytest.mark.parametrize("locked", ["front", "rear"])
def test_friction_is_straight_back_in_straight_motion_and_zero_at_rest(locked):
    load = float(hw.axle_load(locked, mass=1200.0, gravity=9.8, **LENGTHS))
    np.testing.assert_allclose(force(STRAIGHT, locked), [-0.8 * load, 0.0], atol=1e-9)
    np.testing.assert_allclose(force(REST, locked), [0.0, 0.0], atol=1e-12)


def test_a_car_that_turns_left_on_the_spot_drags_its_front_to_the_left_and_its_rear_to_the_right():
    spinning = np.array([0.0, 0.0, 0.0, 0.0, 2.0])
    assert force(spinning, "front")[1] < 0 < force(spinning, "rear")[1]


@pytest.mark.parametrize("locked", ["front", "rear"])
def test_straight_motion_stays_straight_and_rest_stays_rest(locked):
    rates = numbers(hw.state_derivative(0.0, STRAIGHT, locked, **BODY, **ROAD))
    slowing = -0.8 * float(hw.axle_load(locked, mass=1200.0, gravity=9.8, **LENGTHS)) / 1200.0
    np.testing.assert_allclose(rates, [20 * math.cos(0.3), 20 * math.sin(0.3), 0.0, slowing, 0.0], atol=1e-9)
    np.testing.assert_allclose(numbers(hw.state_derivative(0.0, REST, locked, **BODY, **ROAD)), np.zeros(5), atol=1e-12)


def test_friction_takes_its_work_from_the_kinetic_energy():
    state, h = np.array([0.0, 0.0, 0.3, 8.0, 0.7]), 1e-6
    rates = numbers(hw.state_derivative(0.0, state, "front", **BODY, **ROAD))
    after, before = (float(hw.kinetic_energy(state + k * h * rates, "front", **BODY)) for k in (1, -1))
    dragging = np.array([8.0, 2.5 * 0.7])  # velocity of the front axle, 2.5 m ahead of the free one
    assert (after - before) / (2 * h) == pytest.approx(force(state, "front") @ dragging, rel=1e-5)


def test_a_straight_car_stops_where_the_textbook_says_and_stays():
    slowing = 0.8 * 9.8 * 1.0 / 2.5
    t = np.array([1.0, 2.0, 1.0 + 2 * 20 / slowing, 1.0 + 3 * 20 / slowing])
    states = numbers(hw.simulate(t, STRAIGHT, "rear", **BODY, **ROAD))
    np.testing.assert_allclose(states[0], STRAIGHT, atol=1e-12)
    assert states[1, 3] == pytest.approx(20 - slowing, rel=1e-5)
    way = 20.0**2 / (2 * slowing)
    for late in states[2:]:
        np.testing.assert_allclose(late[:2], [way * math.cos(0.3), way * math.sin(0.3)], rtol=1e-5)
        np.testing.assert_allclose(late[3:], [0.0, 0.0], atol=5e-3 * 20)  # at a thousandth of 20 m/s it is at rest


def test_one_locked_axle_is_dangerous_at_high_speed():
    critical = float(hw.critical_speed("rear", **LENGTHS, **ROAD))
    assert float(hw.critical_speed("front", **LENGTHS, **ROAD)) == math.inf
    assert hw.yaw_growth_rate(1.1 * critical, "rear", **BODY, **ROAD) > 0
    assert hw.yaw_growth_rate(0.9 * critical, "rear", **BODY, **ROAD) < 0
    assert hw.yaw_growth_rate(30.0, "front", **BODY, **ROAD) < 0


def test_a_small_yaw_rate_changes_at_the_growth_rate():
    slower, slowing = 10.0 - 1e-5, 0.8 * 9.8 * 1.0 / 2.5
    later = float(hw.small_yaw_rate(slower, 10.0, 1e-3, "rear", **BODY, **ROAD))
    growth = float(hw.yaw_growth_rate(10.0, "rear", **BODY, **ROAD))
    assert (later / 1e-3 - 1) / (1e-5 / slowing) == pytest.approx(growth, rel=1e-3)


def test_only_front_and_rear_can_be_locked():
    with pytest.raises(ValueError):
        hw.axle_load("both", mass=1200.0, gravity=9.8, **LENGTHS)
    with pytest.raises(ValueError):
        hw.critical_speed("both", **LENGTHS, **ROAD)
