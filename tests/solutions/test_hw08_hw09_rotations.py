"""The reference solutions of hw08 and hw09 against rotations at 50 digits, and sequences turned by hand."""

import math

import mpmath
import numpy as np
import pytest

from tam570_grader.checks import assignments

hw08, hw09 = assignments.solution("hw08_axis_angle"), assignments.solution("hw09_book")
DRAW = np.random.default_rng(8)
DIGITS = 1e-15  # a few roundings of numbers of size 1; the contract asks for 1e-14
ANGLES = (0.0, 1e-300, 1e-12, 1e-4, 0.3, np.pi / 2, 2.0, np.pi - 1e-9, np.pi, -2.5, 7.0, -100.0)  # rad
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
    return max(abs(mpmath.mpf(float(x)) - y) for x, y in zip(np.ravel(result), expected, strict=True))


@pytest.mark.parametrize("angle", ANGLES)
def test_vectors_and_matrices_turn_by_any_angle(angle):
    for axis in [*np.eye(3), (0, 1, -1), *DRAW.normal(size=(3, 3))]:
        (precise, _), v = precise_matrix(axis, mpmath.mpf(float(angle))), DRAW.normal(size=3)
        expected = precise * mpmath.matrix([mpmath.mpf(float(x)) for x in v])
        for length in (2.0**-600, 1.0, 2.0**600):
            along = length * np.asarray(axis)
            assert error(hw08.rotation_matrix(along, angle), precise) < DIGITS
            assert error(hw08.rotate(v, along, angle), expected) < DIGITS * np.linalg.norm(v)


def test_skew_is_exact():
    v, r = DRAW.integers(-9, 10, (2, 3)).astype(float)
    np.testing.assert_array_equal(hw08.skew(v) @ r, np.cross(v, r))
    np.testing.assert_array_equal(hw08.skew(v), -hw08.skew(v).T)


@pytest.mark.parametrize("distance", DISTANCES)
@pytest.mark.parametrize("near", [0, 1], ids=["from 0", "from pi"])
def test_axis_and_angle_at_50_digits(near, distance):
    """Of axes with components of very different sizes, some in coordinate planes and along axes."""
    angle = mpmath.pi - mpmath.mpf(distance) if near else mpmath.mpf(distance)
    random = DRAW.normal(size=(15, 3)) * 10 ** DRAW.uniform(-4, 0, (15, 3))
    for axis in [*np.eye(3), *-np.eye(3), (1, -1, 1), (0, 1, -1), *random]:
        precise, n = precise_matrix(axis, angle)
        R = doubles(precise)
        result, result_angle = hw09.axis_angle(R)
        assert error(R, precise_matrix(result, mpmath.mpf(result_angle))[0]) <= DIGITS
        # the rounding of R is an angle of 1e-16: it hides a turn of 1e-15 from pi, but not one from 0
        assert abs(result_angle - angle) <= DIGITS * (1 if near else angle)
        signs = (1, -1) if near and distance < 1e-14 else (1,)
        assert min(error(result, sign * n) for sign in signs) <= DIGITS
        assert math.hypot(*result) == pytest.approx(1.0, rel=DIGITS)


@pytest.mark.parametrize("number", range(20))
def test_sequences_about_axes_of_space_and_of_the_body(number):
    """In space each turn goes before the others; in the body it is about an axis that these have turned."""
    rng, unit = np.random.default_rng(number), np.eye(3)
    steps = [(str(axis), angle) for axis, angle in zip(rng.choice(list("xyz"), 6), rng.normal(size=6), strict=True)]
    space, body, in_body = mpmath.eye(3), np.eye(3), mpmath.eye(3)  # the rows of body: its axes in space
    for axis, angle in steps:
        space = precise_matrix(unit["xyz".index(axis)], mpmath.mpf(angle))[0] * space
        turn = precise_matrix(body["xyz".index(axis)], mpmath.mpf(angle))[0]
        body, in_body = body @ doubles(turn).T, turn * in_body
    assert error(hw09.space_sequence(steps), space) <= DIGITS * len(steps)
    assert error(hw09.body_sequence(steps), in_body) <= DIGITS * len(steps)
