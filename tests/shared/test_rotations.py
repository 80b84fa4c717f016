"""Rotations: laws, batches, and messages about wrong input."""

import numpy as np
import pytest

from tam570 import rotations
from tam570.rotations import SEQUENCES

EPS = np.finfo(float).eps
DRAW = np.random.default_rng(570)
VECTORS = DRAW.normal(size=(40, 3))
ANGLES = DRAW.uniform(-3, 3, (40, 3))
QUATERNIONS = DRAW.normal(size=(40, 4))
MATRICES = rotations.exp(VECTORS)


def largest(difference):
    return np.abs(difference).max()


def test_skew_is_the_cross_product_and_unskew_its_inverse():
    S = rotations.skew(VECTORS)
    assert np.array_equal(np.swapaxes(S, -1, -2), -S)
    # rounding of sums of two products of numbers below 4
    assert largest(np.einsum("nij,nj->ni", S, ANGLES) - np.cross(VECTORS, ANGLES)) < 16 * EPS
    assert np.array_equal(rotations.unskew(S), VECTORS)
    assert largest(rotations.unskew(S + np.eye(3)) - VECTORS) == 0  # the symmetric part does not count


@pytest.mark.parametrize("sequence", sorted(SEQUENCES))
def test_in_gimbal_lock_the_first_angle_is_zero(sequence):
    """Matrices of quarter turns, rounded to signed permutations, are exactly in lock, with zeros of either sign."""
    locks = (0.0, np.pi) if sequence[0] == sequence[2] else (np.pi / 2, -np.pi / 2)
    quarters = np.pi / 2 * np.arange(4)
    for middle in locks:
        angles = np.array([(a, middle, c) for a in quarters for c in quarters])
        R = np.round(rotations.matrix_from_euler(sequence, angles))
        for back in (rotations.euler_from_matrix(sequence, R), [rotations.euler_from_matrix(sequence, r) for r in R]):
            assert (np.asarray(back)[:, 0] == 0).all()
            assert largest(rotations.matrix_from_euler(sequence, back) - R) < 4 * EPS


def test_nearest_needs_no_singular_values_near_a_rotation(monkeypatch):
    monkeypatch.setattr(np.linalg, "svd", None)
    noisy = MATRICES + 1e-2 * DRAW.normal(size=(40, 3, 3))
    assert largest(rotations.nearest(rotations.nearest(noisy)) - rotations.nearest(noisy)) < 4 * EPS


def test_batches_broadcast_and_may_be_empty_or_longer_than_a_block():
    assert rotations.matrix_from_axis_angle([0, 0, 1], np.zeros((2, 5))).shape == (2, 5, 3, 3)
    assert rotations.matrix_from_axis_angle(VECTORS, 1.0).shape == (40, 3, 3)
    assert rotations.composition(QUATERNIONS[:, None], QUATERNIONS).shape == (40, 40, 4)
    assert rotations.exp(np.empty((0, 3))).shape == (0, 3, 3)
    many = np.tile(VECTORS, (250, 1))
    assert np.array_equal(rotations.exp(many)[-40:], rotations.exp(VECTORS))


@pytest.mark.parametrize(
    ("call", "name", "remedy"),
    [
        (lambda: rotations.matrix_from_axis_angle([0, 0, 0], 1), "axis", "along the axis"),
        (lambda: rotations.matrix_from_axis_angle([[1, 0, 0], [0, np.nan, 0]], 1), "axis", "along the axis"),
        (lambda: rotations.matrix_from_axis_angle([1, 0, 0], np.inf), "angle", "finite"),
        (lambda: rotations.matrix_from_axis_angle([1, 0], 0), "axis", r"\(\.\.\., 3\)"),
        (lambda: rotations.matrix_from_quaternion([0, 0, 0, 0]), "q", "1, 0, 0, 0"),
        (lambda: rotations.composition([1, 0, 0, np.inf], [1, 0, 0, 0]), "p", "finite"),
        (lambda: rotations.exp([0, np.inf, 0]), "v", "finite"),
        (lambda: rotations.skew([0, np.nan, 0]), "v", "finite"),
        (lambda: rotations.log(np.full((3, 3), np.nan)), "R", "nearest"),
        (lambda: rotations.quaternion_from_matrix(np.diag([1, 1, -1.0])), "R", "nearest"),
        (lambda: rotations.axis_angle_from_matrix(2 * np.eye(3)), "R", "nearest"),
        (lambda: rotations.euler_from_matrix("313", np.eye(3) + 1e-5), "R", "nearest"),
        (lambda: rotations.euler_from_matrix("313", np.eye(4)), "R", "3, 3"),
        (lambda: rotations.matrix_from_euler("331", [0, 0, 0]), "sequence", "312, 313"),
        (lambda: rotations.matrix_from_euler("313", [0, np.inf, 0]), "angles", "finite"),
        (lambda: rotations.euler_rates("313", [1, 0, 1], [1, 1, 1]), "angles", "another sequence"),
        (lambda: rotations.euler_rates("312", [1, np.pi / 2, 1], [1, 1, 1]), "angles", "another sequence"),
        (lambda: rotations.matrix_from_axis_angle(VECTORS, [1, 2]), "axis and angle", "broadcast"),
        (lambda: rotations.nearest(np.zeros((3, 3))), "M", "near one rotation"),
        (lambda: rotations.nearest(-np.eye(3)), "M", "near one rotation"),
    ],
)
def test_wrong_input_is_named_with_its_remedy(call, name, remedy):
    with pytest.raises(ValueError, match=f"^{name} .*{remedy}"):
        call()
