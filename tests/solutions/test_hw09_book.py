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


def error(result, expected):
    """Largest difference, taken at 50 digits."""
    pairs = zip(np.ravel(result), expected, strict=True)
    return max(abs(mpmath.mpf(float(x)) - y) for x, y in pairs)


def axes(count):
    """Axes with components of very different sizes, some in coordinate planes and along axes."""
    special = [*np.eye(3), *-np.eye(3), (1, -1, 1), (0, 1, -1)]
    return [*special, *(DRAW.normal(size=(count, 3)) * 10 ** DRAW.uniform(-4, 0, (count, 3)))]


@pytest.mark.parametrize("distance", DISTANCES)
@pytest.mark.parametrize("near", [0, 1], ids=["from 0", "from pi"])
def test_axis_and_angle_at_50_digits(near, distance):
    angle = mpmath.pi - mpmath.mpf(distance) if near else mpmath.mpf(distance)
    for axis in axes(15):
        precise, n = precise_matrix(axis, angle)
        R = doubles(precise)
        result, found_angle = hw.axis_angle(R)
        turned, _ = precise_matrix(result, mpmath.mpf(found_angle))
        assert error(R, turned) <= DIGITS
        # the rounding of R is an angle of 1e-16: it hides a turn of 1e-15 from pi, but not one from 0
        assert abs(found_angle - angle) <= DIGITS * (1 if near else angle)
        signs = (1, -1) if near and distance < 1e-14 else (1,)
        assert min(error(result, sign * n) for sign in signs) <= DIGITS
        assert math.hypot(*result) == pytest.approx(1.0, rel=DIGITS)


def random_steps():
    return [(str(axis), angle) for axis, angle in zip(DRAW.choice(list("xyz"), 6), DRAW.normal(size=6), strict=True)]


def test_a_space_sequence_at_50_digits():
    unit = dict(zip("xyz", np.eye(3), strict=True))
    for steps in (random_steps() for _ in range(20)):
        R = mpmath.eye(3)
        for axis, angle in steps:
            R = precise_matrix(unit[axis], mpmath.mpf(angle))[0] * R
        assert error(hw.space_sequence(steps), R) <= DIGITS * len(steps)


def test_a_body_sequence_turns_about_axes_that_earlier_turns_have_turned():
    for steps in (random_steps() for _ in range(20)):
        body, R = np.eye(3), mpmath.eye(3)  # the rows of body: its axes in space
        for axis, angle in steps:
            turn = precise_matrix(body["xyz".index(axis)], mpmath.mpf(angle))[0]
            body, R = body @ doubles(turn).T, turn * R
        assert error(hw.body_sequence(steps), R) <= DIGITS * len(steps)
