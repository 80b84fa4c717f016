"""hw08's reference solution against a matrix exponential at 50 digits."""

import mpmath
import numpy as np
import pytest

from tam570_grader.checks import assignments

hw = assignments.solution("hw08_axis_angle")

DRAW = np.random.default_rng(8)
DIGITS = 1e-15  # a few roundings of numbers of size 1
ANGLES = (0.0, 1e-300, 1e-12, 1e-4, 0.3, np.pi / 2, 2.0, np.pi - 1e-9, np.pi, -2.5, 7.0, -100.0)  # rad


def precise_matrix(axis, angle):
    """exp(angle [n x]), a series at 50 digits; doubles are exact there."""
    axis = mpmath.matrix([mpmath.mpf(float(x)) for x in axis])
    x, y, z = axis / mpmath.norm(axis)
    return mpmath.expm(mpmath.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]]) * mpmath.mpf(float(angle)))


def error(result, expected):
    """Largest difference, taken at 50 digits."""
    return max(abs(mpmath.mpf(float(x)) - y) for x, y in zip(np.ravel(result), expected, strict=True))


@pytest.mark.parametrize("angle", ANGLES)
def test_vectors_and_matrices_turn_as_by_the_exponential(angle):
    for axis in [*np.eye(3), (0, 1, -1), *DRAW.normal(size=(3, 3))]:
        precise, v = precise_matrix(axis, angle), DRAW.normal(size=3)
        expected = precise * mpmath.matrix([mpmath.mpf(float(x)) for x in v])
        for length in (2.0**-600, 1.0, 2.0**600):
            along = length * np.asarray(axis)
            assert error(hw.rotation_matrix(along, angle), precise) < DIGITS
            assert error(hw.rotate(v, along, angle), expected) < DIGITS * np.linalg.norm(v)


def test_skew_is_exact():
    v, r = DRAW.integers(-9, 10, (2, 3)).astype(float)
    np.testing.assert_array_equal(hw.skew(v) @ r, np.cross(v, r))
    np.testing.assert_array_equal(hw.skew(v), -hw.skew(v).T)
