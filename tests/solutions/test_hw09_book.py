"""hw09's reference solution against rotations at 50 digits, and against the sequences turned by hand."""

import math

import mpmath
import numpy as np
import pytest

from tam570_grader.checks import assignments

hw = assignments.solution("hw09_book")

DRAW = np.random.default_rng(9)
DIGITS = 1e-15  # a few roundings of numbers of size 1; the contract asks for 1e-14
DISTANCES = (1.5, 0.1, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15)  # rad, from 0 and from pi


def precise_matrix(axis, angle):
    """cos I + sin [n x] + (1 - cos) n n^T at 50 digits, and n; the axis may have any length."""
    v = mpmath.matrix([mpmath.mpf(float(x)) for x in axis])
    n = v / mpmath.norm(v)
    c, s = mpmath.cos(angle), mpmath.sin(angle)
    cross = mpmath.matrix([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])
    return c * mpmath.eye(3) + s * cross + (1 - c) * n * n.T, n


def doubles(matrix):
    return np.array(matrix.tolist(), dtype=float)


def error(found, right):
    """Largest difference, taken at 50 digits."""
    pairs = zip(np.ravel(found), right, strict=True)
    return max(abs(mpmath.mpf(float(x)) - y) for x, y in pairs)


def axes(count):
    """Axes with components of very different sizes, some in coordinate planes and along axes."""
    special = [*np.eye(3), *-np.eye(3), (1, -1, 1), (0, 1, -1)]
    return [*special, *(DRAW.normal(size=(count, 3)) * 10 ** DRAW.uniform(-4, 0, (count, 3)))]


@pytest.mark.parametrize("distance", DISTANCES)
@pytest.mark.parametrize("near", [0, 1], ids=["from 0", "from pi"])
def test_axis_and_angle_at_50_digits(near, distance):
    with mpmath.workdps(50):
        angle = mpmath.pi - mpmath.mpf(distance) if near else mpmath.mpf(distance)
        for axis in axes(15):
            precise, n = precise_matrix(axis, angle)
            R = doubles(precise)
            found, found_angle = hw.axis_angle(R)
            again, _ = precise_matrix(found, mpmath.mpf(found_angle))
            assert error(R, again) <= DIGITS
            # the rounding of R is an angle of 1e-16: it hides a turn of 1e-15 from pi, but not one from 0
            assert abs(found_angle - angle) <= DIGITS * (1 if near else angle)
            signs = (1, -1) if near and distance < 1e-14 else (1,)
            assert min(error(found, sign * n) for sign in signs) <= DIGITS
            assert math.hypot(*found) == pytest.approx(1.0, rel=DIGITS)


def test_half_turns_and_no_turn():
    for axis in axes(40):
        n = np.array(axis) / math.hypot(*axis)
        found, angle = hw.axis_angle(2 * np.outer(n, n) - np.eye(3))
        assert angle == pytest.approx(math.pi, abs=DIGITS)
        np.testing.assert_allclose(np.outer(found, found), np.outer(n, n), rtol=0, atol=DIGITS)
    found, angle = hw.axis_angle(np.eye(3))
    assert (math.hypot(*found), angle) == (1.0, 0.0)


@pytest.mark.parametrize(("which", "along"), [(0, (1, -1, 1)), (1, (1, 1, 1))])
def test_both_turns_of_the_book_are_120_degrees(which, along):
    R = hw.book_rotations()[which]
    n, angle = hw.axis_angle(R)
    assert angle == pytest.approx(2 * math.pi / 3, rel=DIGITS)
    np.testing.assert_allclose(n, np.array(along) / math.sqrt(3), rtol=0, atol=DIGITS)
    np.testing.assert_allclose(R @ n, n, rtol=0, atol=DIGITS)
    assert np.trace(R) == pytest.approx(1 + 2 * math.cos(angle), abs=DIGITS)


def random_steps():
    return [(str(axis), angle) for axis, angle in zip(DRAW.choice(list("xyz"), 6), DRAW.normal(size=6), strict=True)]


def test_a_space_sequence_is_the_body_sequence_reversed():
    for steps in (random_steps() for _ in range(20)):
        reversed_body = hw.body_sequence(steps[::-1])
        np.testing.assert_allclose(hw.space_sequence(steps), reversed_body, rtol=0, atol=1e-15 * len(steps))


def test_a_space_sequence_at_50_digits():
    unit = dict(zip("xyz", np.eye(3), strict=True))
    with mpmath.workdps(50):
        for steps in (random_steps() for _ in range(20)):
            R = mpmath.eye(3)
            for axis, angle in steps:
                R = precise_matrix(unit[axis], mpmath.mpf(angle))[0] * R
            assert error(hw.space_sequence(steps), R) <= DIGITS * len(steps)


def test_a_body_sequence_turns_about_axes_that_earlier_turns_have_turned():
    with mpmath.workdps(50):
        for steps in (random_steps() for _ in range(20)):
            body, R = np.eye(3), mpmath.eye(3)  # the rows of body: its axes in space
            for axis, angle in steps:
                turn = precise_matrix(body["xyz".index(axis)], mpmath.mpf(angle))[0]
                body, R = body @ doubles(turn).T, turn * R
            assert error(hw.body_sequence(steps), R) <= DIGITS * len(steps)


def bad_matrices():
    R = hw.space_sequence([("x", 0.3), ("y", 1.0)])
    yield from (-R, 1.001 * R, np.zeros((3, 3)), R[::-1], 1e200 * R, -1e-200 * R)
    for bad in (np.nan, np.inf, -np.inf, 1e300):
        for place in np.ndindex(3, 3):
            broken = R.copy()
            broken[place] = bad
            yield broken


def test_what_is_no_rotation_is_refused():
    for matrix in bad_matrices():
        with pytest.raises(ValueError, match="no rotation"):
            hw.axis_angle(matrix)


def test_the_limit_of_the_defect_is_1e_6():
    shear = np.array([[0, 1, 0], [1, 0, 0], [0, 0, 0]])  # R^T R - I is twice its size
    R = hw.axis_rotation("z", 0.4)
    n, angle = hw.axis_angle(R @ (np.eye(3) + 0.4999e-6 * shear))
    np.testing.assert_allclose([*n, angle], [0, 0, 1, 0.4], rtol=0, atol=1e-6)
    with pytest.raises(ValueError):
        hw.axis_angle(R @ (np.eye(3) + 0.5001e-6 * shear))


@pytest.mark.parametrize("axis", ["", "xy", "X", "w", "-z"])
def test_other_axes_are_refused(axis):
    with pytest.raises(ValueError, match="axis"):
        hw.axis_rotation(axis, 1.0)


def test_the_edges_keep_lengths_and_angles():
    for _ in range(20):
        size = 10 ** DRAW.uniform(-3, 3, 3)
        R = hw.space_sequence(random_steps())
        ends = hw.book_edges(R, size=size) @ R / size  # back along the axes, in units of the size
        assert len({tuple(np.sign(edge).ravel()) for edge in np.round(ends, 9)}) == 12
        np.testing.assert_allclose(np.abs(ends), 0.5, rtol=1e-14 * max(size) / min(size))
        spans = np.abs(ends[:, 1] - ends[:, 0])
        np.testing.assert_allclose(spans.sum(axis=1), 1.0, rtol=1e-13 * max(size) / min(size))
