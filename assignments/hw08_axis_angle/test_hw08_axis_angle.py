"""Visible tests of hw08: run them with `tam570 check hw08` (or plain pytest) as often as you like."""

from functools import partial

import hw08_axis_angle as hw
import numpy as np
import pytest

X, Y, Z = np.eye(3)
AXIS, ANGLE = np.array([1.0, -2.0, 2.0]), 0.7  # length 3, rad
numbers = partial(np.asarray, dtype=float)  # of a result, whatever kind of numbers or lists it came as


def test_skew_is_the_cross_product():
    v, r = np.array([1.0, 2.0, 3.0]), np.array([-2.0, 0.5, 4.0])
    np.testing.assert_allclose(numbers(hw.skew(v)) @ r, np.cross(v, r), atol=1e-14)


def test_a_quarter_turn_about_z_takes_x_to_y():
    np.testing.assert_allclose(numbers(hw.rotation_matrix(Z, np.pi / 2)) @ X, Y, atol=1e-14)


def test_the_matrix_keeps_lengths_and_handedness():
    R = numbers(hw.rotation_matrix(AXIS, ANGLE))
    np.testing.assert_allclose(R.T @ R, np.eye(3), atol=1e-14)
    assert np.linalg.det(R) == pytest.approx(1.0)


def test_the_axis_stays():
    np.testing.assert_allclose(numbers(hw.rotation_matrix(AXIS, ANGLE)) @ AXIS, AXIS, atol=1e-14)


def test_rotate_agrees_with_the_matrix():
    r = np.array([0.3, -1.0, 2.0])
    np.testing.assert_allclose(
        numbers(hw.rotate(r, AXIS, ANGLE)), numbers(hw.rotation_matrix(AXIS, ANGLE)) @ r, atol=1e-14
    )


NO_AXES = [np.zeros(3), np.array([np.nan, 0.0, 1.0]), np.array([-np.inf, 0.0, 1.0])]


@pytest.mark.parametrize("axis", NO_AXES)
def test_the_matrix_refuses_what_is_no_axis(axis):
    for angle in (ANGLE, 0.0):
        with pytest.raises(ValueError):
            hw.rotation_matrix(axis, angle)


@pytest.mark.parametrize("axis", NO_AXES)
def test_rotate_refuses_what_is_no_axis(axis):
    for r in (X, np.zeros(3)):
        with pytest.raises(ValueError):
            hw.rotate(r, axis, ANGLE)
