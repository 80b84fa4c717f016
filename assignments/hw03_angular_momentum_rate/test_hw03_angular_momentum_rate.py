"""Visible tests of hw03: run them with `tam570 check hw03` (or plain pytest) as often as you like."""

from functools import partial

import hw03_angular_momentum_rate as hw
import numpy as np
import pytest
from numpy.polynomial import polynomial

X, Y, Z = np.eye(3)
NONE = np.zeros(3)
numbers = partial(np.asarray, dtype=float)  # of a result, whatever kind of numbers or lists it came as


def test_the_moment_of_a_force_along_y_at_a_place_on_x():
    assert numbers(hw.moment(3 * X, 2 * Y, X, mass=5.0)) == pytest.approx(20 * Z)  # arm 2 m, force 10 N


def test_definition_b_sees_the_velocity_in_F_and_c_that_relative_to_C():
    state = 2 * X, 3 * Y, NONE, Y
    assert numbers(hw.angular_momentum("a", *state, mass=0.5)) == pytest.approx(3 * Z)
    assert numbers(hw.angular_momentum("b", *state, mass=0.5)) == pytest.approx(3 * Z)
    assert numbers(hw.angular_momentum("c", *state, mass=0.5)) == pytest.approx(2 * Z)


@pytest.mark.parametrize("definition", ["a", "b", "c"])
def test_about_a_point_at_rest_every_definition_holds(definition):
    state = X + 2 * Y, 3 * Z - X, Y - Z, Y, NONE, NONE
    expected = numbers(hw.moment(state[0], state[2], state[3], mass=2.0))
    assert numbers(hw.rate(definition, *state, mass=2.0)) == pytest.approx(expected)
    assert numbers(hw.discrepancy(definition, *state, mass=2.0)) == pytest.approx(NONE)


def at(p, t):
    """Position, velocity, acceleration of the motion with coefficients p."""
    p = np.asarray(p, float)
    return tuple(polynomial.polyval(t, polynomial.polyder(np.vstack([p, np.zeros((2, 3))]), n)) for n in range(3))


@pytest.mark.parametrize("definition", ["b", "c"])
def test_the_rate_is_the_slope_of_the_angular_momentum(definition):
    p, c, step = [X, 2 * Y, Z - X], [Y, X + Z, -Y], 1e-5

    def momentum(t):
        return numbers(hw.angular_momentum(definition, *at(p, t)[:2], *at(c, t)[:2], mass=2.0))

    slope = (momentum(0.3 + step) - momentum(0.3 - step)) / (2 * step)
    assert numbers(hw.rate(definition, *at(p, 0.3), *at(c, 0.3), mass=2.0)) == pytest.approx(slope, abs=1e-6)


def test_the_discrepancy_is_rate_less_moment():
    state = X, Y, Z, 2 * Y, X + Z, Y - Z
    for definition in "abc":
        surplus = numbers(hw.rate(definition, *state, mass=3.0)) - numbers(hw.moment(X, Z, 2 * Y, mass=3.0))
        assert numbers(hw.discrepancy(definition, *state, mass=3.0)) == pytest.approx(surplus)


def test_there_are_three_definitions():
    with pytest.raises(ValueError):
        hw.rate("d", *[X] * 6, mass=1.0)


@pytest.mark.parametrize("definition", ["b", "c"])
def test_the_special_motion_keeps_its_promise_at_some_times(definition):
    """At some times only: that it does at every time, and for this definition alone, is for you to make sure."""
    p, c = hw.special_motion(definition)
    for t in (0.0, 0.4, 1.0):
        assert np.any(at(c, t)[1]) and np.any(at(c, t)[2])
        r, v, a = np.linalg.norm(at(p, t), axis=1) + np.linalg.norm(at(c, t), axis=1)
        rounding = 1e-12 * (r * a + v**2)
        discrepancy = numbers(hw.discrepancy(definition, *at(p, t), *at(c, t), mass=1.0))
        assert discrepancy == pytest.approx(NONE, abs=rounding)


@pytest.mark.parametrize(("definition", "other"), [("b", "c"), ("c", "b")])
def test_the_other_definition_fails_on_the_special_motion(definition, other):
    p, c = hw.special_motion(definition)
    states = [(*at(p, t), *at(c, t)) for t in (0.0, 0.3, 0.7, 1.0)]
    assert max(np.abs(numbers(hw.discrepancy(other, *state, mass=1.0))).max() for state in states) > 1e-9
