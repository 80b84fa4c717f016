"""Every conversion is correct to 4 eps where digits are easily lost, compared with textbook formulas in 50 digits.

Errors of matrix entries, unit axes and unit quaternions are absolute; errors of angles and rotation vectors are
relative to the angle, so that the last digits of 1e-300 count, too.
"""

import math

import mpmath
import numpy as np
import pytest
from parameters import first

from tam570 import rotations
from tam570.rotations import SEQUENCES

EPS = np.finfo(float).eps
ALLOWED = 4 * EPS
SMALL = (1e-300, 1e-12, 1e-9, 1e-3)
DRAW = np.random.default_rng(571)
IDENTITY = np.eye(3, dtype=int).astype(object)
UNTURNED = np.array([[1, 0, 0], [0, 0, -1], [1, 1, 1], [1, -1, 1], [1, 1e-9, 1e-12], [1e-9, 1, 1]], dtype=float)
AXES = np.vstack([UNTURNED, DRAW.normal(size=(4, 3))])
ANGLES = [*SMALL, 1.0, math.pi / 2, 2.5, *(math.pi - d for d in SMALL)]


@pytest.fixture(autouse=True)
def fifty_digits():
    with mpmath.workdps(50):
        yield


def exact(array):
    """Return the numbers of an array as numbers of mpmath, without rounding."""
    return np.vectorize(mpmath.mpf, otypes=[object])(np.asarray(array, dtype=float))


def rounded(numbers):
    return np.array(numbers.tolist(), dtype=float)


def error(result, reference):
    return float(np.max(np.abs(exact(result) - reference)))


def unit(axis):
    v = exact(axis)
    return v / mpmath.sqrt((v * v).sum())


def hat(v):
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]], dtype=object)


def exact_matrix(axis, angle):
    """Return the matrix by Rodrigues' formula."""
    n, (c, s) = unit(axis), mpmath.cos_sin(mpmath.mpf(angle))
    return c * IDENTITY + (1 - c) * np.outer(n, n) + s * hat(n)


def exact_euler_matrix(sequence, angles):
    axes = [np.eye(3)[int(digit) - 1] for digit in sequence]
    first, second, third = map(exact_matrix, axes, map(float, angles))
    return first @ second @ third


def singly_and_in_a_batch(function, *arguments):
    """Yield the result of a conversion for one rotation, and for the first in a batch of two."""
    yield function(*arguments)
    pair = function(*(np.array([a, a]) for a in arguments))
    yield tuple(part[0] for part in pair) if isinstance(pair, tuple) else pair[0]


def exact_quaternion_matrix(q):
    """Return ((w^2 - v^2) I + 2 v v^T + 2 w skew(v)) / (w^2 + v^2)."""
    w, v = exact(q)[0], exact(q)[1:]
    return ((w * w - v @ v) * IDENTITY + 2 * np.outer(v, v) + 2 * w * hat(v)) / (w * w + v @ v)


def conversions(axis, angle):
    """Yield (function, its arguments, function result -> error), the error absolute or relative to the angle."""
    n, R = unit(axis), rounded(exact_matrix(axis, angle))
    v, half = angle * rounded(n), mpmath.mpf(angle) / 2
    by_vector = exact_matrix(v, mpmath.sqrt((exact(v) ** 2).sum()))
    quaternion = np.array([mpmath.cos(half), *(mpmath.sin(half) * n)])

    def apart(vector, direction):
        """Return the largest component of the difference; near half a turn, of either sign."""
        return min(error(vector, s * direction) for s in ((1, -1) if angle > math.pi - 1e-15 else (1,)))

    yield rotations.axis_angle_from_matrix, (R,), lambda pair: max(apart(pair[0], n), error(pair[1], 2 * half) / angle)
    yield rotations.log, (R,), lambda vector: apart(vector, angle * n) / angle
    yield rotations.exp, (v,), lambda matrix: error(matrix, by_vector)
    yield rotations.quaternion_from_matrix, (R,), lambda q: apart(q, quaternion) if q[0] >= 0 else math.inf
    for length in (1, 1e-200, 1e200, 5e-324, 1e308):
        scaled = axis / np.abs(axis).max() * length
        for signed in (angle, -angle):
            by_axis = exact_matrix(scaled, signed)
            yield rotations.matrix_from_axis_angle, (scaled, signed), lambda matrix, to=by_axis: error(matrix, to)
    for length in (1, 1e-200, 1e200, 1e308):
        q = length * np.array([math.cos(0.5 * angle), *(math.sin(0.5 * angle) * rounded(n))])
        by_quaternion = exact_quaternion_matrix(q)
        yield rotations.matrix_from_quaternion, (q,), lambda matrix, to=by_quaternion: error(matrix, to)


@pytest.mark.parametrize("axis", first(len(UNTURNED) + 1, AXES))
def test_a_conversion_of_any_axis_and_angle(axis):
    for angle in ANGLES:
        for function, arguments, off in conversions(axis, angle):
            for result in singly_and_in_a_batch(function, *arguments):
                assert off(result) <= ALLOWED, (function, angle)


def test_round_trips_next_to_half_a_turn():
    """Near half a turn, rounding a rotation vector costs 2 eps, so its length must be correct to the last digit."""
    rng = np.random.default_rng(573)
    axes, size = rng.normal(size=(100_000, 3)), 10.0 ** rng.uniform(-14, -3, 100_000)
    R = rotations.matrix_from_axis_angle(axes, math.pi - size)
    assert np.abs(rotations.exp(rotations.log(R)) - R).max() <= ALLOWED
    assert np.abs(rotations.matrix_from_axis_angle(*rotations.axis_angle_from_matrix(R)) - R).max() <= ALLOWED


def middle_angles(sequence):
    """Return middle angles in gimbal lock, near it and away from it."""
    if sequence[0] == sequence[2]:
        return [0.0, *SMALL, 1.0, *(math.pi - d for d in (0, *SMALL))]
    return [*SMALL, 1.0, *(s * (math.pi / 2 - d) for d in (0, *SMALL) for s in (1, -1))]


@pytest.mark.parametrize("sequence", first(4, sorted(SEQUENCES)))
def test_euler_angles_to_matrix_and_back(sequence):
    for middle in middle_angles(sequence):
        for start, end in [(1e-12, math.pi - 1e-9), (-1e-300, 1e-9), *DRAW.uniform(-3, 3, (2, 2))]:
            angles = np.array([start, middle, end])
            reference = exact_euler_matrix(sequence, angles)
            for R in singly_and_in_a_batch(lambda a: rotations.matrix_from_euler(sequence, a), angles):
                assert error(R, reference) <= ALLOWED, angles
            for back in singly_and_in_a_batch(lambda R: rotations.euler_from_matrix(sequence, R), R):
                assert error(R, exact_euler_matrix(sequence, back)) <= ALLOWED, angles
                if middle != 0:  # in lock only the sum or the difference is determined
                    assert error(back, exact(angles)) <= ALLOWED, angles


def matrices_to_mend():
    """Yield rotations with little noise and extreme sizes, and with much noise, where singular vectors lose a digit."""
    rng = np.random.default_rng(574)
    for i, R in enumerate(rotations.exp(rng.normal(size=(60, 3)))):
        noise = rng.normal(size=(3, 3))
        yield from (R + noise, 0.3 * noise - R)
        if i < 5:
            yield from (R, R + 1e-12 * noise, R + 1e-3 * noise, 1e200 * R, 1e-200 * R)


def test_nearest_rotation():
    """`nearest` agrees with singular vectors in 50 digits, up to rounding of M times its condition, max over sum."""
    for M in matrices_to_mend():
        U, stretch, Vt = mpmath.svd_r(mpmath.matrix(M.tolist()))
        sign = mpmath.sign(mpmath.det(U * Vt))
        reference = np.array((U * mpmath.diag([1, 1, sign]) * Vt).tolist()).reshape(3, 3)
        condition = max(1.0, float(stretch[0] / (stretch[1] + sign * stretch[2])))
        for nearest in singly_and_in_a_batch(rotations.nearest, M):
            assert error(nearest, reference) <= ALLOWED * condition, M


@pytest.mark.parametrize("sequence", first(4, sorted(SEQUENCES)))
def test_euler_rates_next_to_gimbal_lock(sequence):
    """The exact rates solve R^T R' = skew(omega); the error is relative to |omega| / distance from lock."""
    for middle in middle_angles(sequence):
        lock = math.sin(middle) if sequence[0] == sequence[2] else math.cos(middle)
        if abs(lock) > 1e-11:
            angles, omega = np.array([0.3, middle, -2.0]), DRAW.normal(size=3)
            for rates in singly_and_in_a_batch(lambda a, w: rotations.euler_rates(sequence, a, w), angles, omega):
                allowed = ALLOWED * np.linalg.norm(omega) / abs(lock)
                assert error(rates, exact_rates(sequence, angles, omega)) <= allowed, (angles, omega)


def exact_rates(sequence, angles, omega):
    """Return the rates that give omega; each angle turns the body about its axis, seen after the later turns."""
    later = IDENTITY
    columns = []
    for digit, angle in zip(reversed(sequence), reversed(angles), strict=True):
        axis = np.eye(3)[int(digit) - 1]
        columns.append(later.T @ exact(axis))
        later = exact_matrix(axis, float(angle)) @ later
    solution = mpmath.lu_solve(mpmath.matrix(np.array(columns[::-1]).T.tolist()), mpmath.matrix(exact(omega).tolist()))
    return np.array(list(solution))
