"""Visible tests of hw09: run them with `tam570 check hw09` (or plain pytest) as often as you like."""

from functools import partial

import hw09_book as hw
import numpy as np
import pytest

X, Y, Z = np.eye(3)
STEPS = [("z", 0.3), ("x", -1.1), ("y", 2.0)]
numbers = partial(np.asarray, dtype=float)  # of a result, whatever kind of numbers or lists it came as


def turned(n, angle):
    """The rotation by `angle` about the unit vector n, from hw08's formula."""
    c, s = np.cos(angle), np.sin(angle)
    return np.transpose([c * e + (1 - c) * (n @ e) * n + s * np.cross(n, e) for e in np.eye(3)])


@pytest.mark.parametrize(("axis", "start", "end"), [("x", Y, Z), ("y", Z, X), ("z", X, Y)])
def test_quarter_turns(axis, start, end):
    np.testing.assert_allclose(numbers(hw.axis_rotation(axis, np.pi / 2)) @ start, end, atol=1e-14)


def test_there_is_no_axis_w():
    with pytest.raises(ValueError):
        hw.axis_rotation("w", 1.0)


def test_two_steps_about_space_axes():
    # a quarter turn about z takes x to y, one about x takes that to z
    R = numbers(hw.space_sequence([("z", np.pi / 2), ("x", np.pi / 2)]))
    np.testing.assert_allclose(R @ X, Z, atol=1e-14)


def test_two_steps_about_body_axes():
    # the x axis of the body is along y after a quarter turn about z, and stays there
    R = numbers(hw.body_sequence([("z", np.pi / 2), ("x", np.pi / 2)]))
    np.testing.assert_allclose(R @ X, Y, atol=1e-14)


@pytest.mark.parametrize("sequence", ["space_sequence", "body_sequence"])
def test_a_sequence_undone_is_no_turn(sequence):
    undone = [(axis, -angle) for axis, angle in reversed(STEPS)]
    np.testing.assert_allclose(numbers(getattr(hw, sequence)(STEPS + undone)), np.eye(3), atol=1e-14)


def test_the_book_turns_by_the_same_angle_about_different_axes():
    (n_a, angle_a), (n_b, angle_b) = (hw.axis_angle(numbers(R)) for R in hw.book_rotations())
    assert float(angle_a) == pytest.approx(float(angle_b))
    assert abs(numbers(n_a) @ numbers(n_b)) < 0.9


@pytest.mark.parametrize("angle", [1.0, 3.0, 1e-11, np.pi - 1e-9, np.pi])
def test_axis_and_angle_make_the_matrix_again(angle):
    R = turned(np.array([2.0, -1.0, 2.0]) / 3, angle)
    n, measured = hw.axis_angle(R)
    np.testing.assert_allclose(turned(numbers(n), float(measured)), R, atol=1e-13)
    assert abs(numbers(n) @ [2.0, -1.0, 2.0]) == pytest.approx(3.0, rel=1e-12)
    assert float(measured) == pytest.approx(angle, rel=1e-10)


@pytest.mark.parametrize("R", [np.eye(3), (1 + 4e-16) * np.eye(3)])
def test_no_turn_has_a_unit_axis(R):
    """Rounding can make the trace larger than 3."""
    n, angle = hw.axis_angle(R)
    assert float(angle) == pytest.approx(0.0, abs=1e-7)
    assert np.linalg.norm(numbers(n)) == pytest.approx(1.0)


def test_a_half_turn_has_an_axis():
    n, angle = hw.axis_angle(np.diag([-1.0, 1.0, -1.0]))
    assert float(angle) == pytest.approx(np.pi)
    np.testing.assert_allclose(np.abs(numbers(n)), Y, atol=1e-14)


def test_a_reflection_is_refused():
    with pytest.raises(ValueError):
        hw.axis_angle(np.diag([1.0, 1.0, -1.0]))


def test_the_edges_turn_with_the_book():
    R = turned(Y, 0.4)
    edges = numbers(hw.book_edges(R, size=np.array([1.0, 2.0, 3.0])))
    lengths = np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1)
    np.testing.assert_allclose(np.sort(lengths), [1] * 4 + [2] * 4 + [3] * 4, atol=1e-12)
    np.testing.assert_allclose(np.abs(edges @ R), np.broadcast_to([0.5, 1.0, 1.5], (12, 2, 3)), atol=1e-12)
