"""Requirements of arguments, and the scaling or repair of unusual ones."""

import numpy as np
from numpy.typing import NDArray

from tam570.rotations._evaluate import Array, Requirement
from tam570.rotations._formulas import defect

# Ranges of the measures of arguments that need no closer look; 0 for those that must only be finite
SQUARES = (1e-6, 1e250)  # squared lengths; the least does not underflow when multiplied by an angle of 1e-300
TURNS = (0.0, 1e300)  # squared lengths of rotation vectors, which may underflow
STEPS = (0.0, 1e-18)  # square of Newton's last step, which leaves an error of half its square
DEFECTS = (0.0, 1e-12)  # sum of squared errors of a matrix within 1e-6 of a rotation


def _is_finite(rows: Array) -> NDArray[np.bool_]:
    return np.asarray(np.isfinite(rows).all(axis=1))


def _is_short(rows: Array) -> NDArray[np.bool_]:
    return np.asarray(np.abs(rows).max(axis=1) < 1e150)


def _is_direction(rows: Array) -> NDArray[np.bool_]:
    return _is_finite(rows) & rows.any(axis=1)


def _is_rotation(rows: Array) -> NDArray[np.bool_]:
    return np.asarray(defect(*rows.T) <= DEFECTS[1])


def _has_one_nearest(rows: Array) -> NDArray[np.bool_]:
    """Return whether the two smaller singular values, the last negated for a left-handed matrix, do not cancel."""
    finite = _is_finite(rows)
    matrices = np.where(finite[:, None], rows, 0.0).reshape(-1, 3, 3)
    U, stretch, Vt = np.linalg.svd(matrices)
    cancelled = stretch[:, 1] + np.linalg.det(U @ Vt) * stretch[:, 2] <= 1e-15 * stretch[:, 0]  # round-off
    return np.asarray(finite & ~cancelled)


def _nearest_by_svd(rows: Array) -> Array:
    """Return the nearest rotations, also where Newton's iteration is slow or a matrix left-handed (Kabsch 1978).

    At the nearest rotation R^T M is symmetric. A turn by the rest of its antisymmetric part removes the rounding errors
    of the singular vectors.
    """
    M = rows.reshape(-1, 3, 3)
    M = M / np.abs(M).max(axis=(1, 2), keepdims=True)
    U, _, Vt = np.linalg.svd(M)
    U[:, :, 2] *= np.sign(np.linalg.det(U @ Vt))[:, None]
    R = U @ Vt
    S = np.swapaxes(R, 1, 2) @ M
    stiffness = np.trace(S, axis1=1, axis2=2)[:, None, None] * np.eye(3) - S
    residual = np.cross(np.eye(3), np.swapaxes(S, 1, 2)).sum(axis=1)  # e_i x S e_i, summed
    turn = np.linalg.solve(stiffness, residual[:, :, None])[:, :, 0]
    return np.asarray((R + np.cross(R, turn[:, None, :])).reshape(-1, 9))  # the rows of R skew(turn)


def _into_range(rows: Array) -> Array:
    """Scale rows by powers of two, exactly, so that the largest component is in [1/2, 1)."""
    _, exponent = np.frexp(np.abs(rows).max(axis=1, keepdims=True))
    return np.asarray(np.ldexp(rows, -exponent))


ANGLE = Requirement((), _is_finite, "must be finite")
VECTOR = Requirement((3,), _is_finite, "must be finite")
MATRIX = Requirement((3, 3), _is_finite, "must be finite")
FACTOR = Requirement((4,), _is_finite, "must be finite")
TURN = Requirement((3,), _is_short, "must be finite and shorter than 1e150 rad", measures=TURNS)
AXIS = Requirement(
    (3,), _is_direction, "must be finite and not zero: give a vector along the axis", _into_range, SQUARES
)
QUATERNION = Requirement(
    (4,), _is_direction, "must be finite and not zero: no turn is (1, 0, 0, 0)", _into_range, SQUARES
)
NEAR_ONE = Requirement((3, 3), _has_one_nearest, "must be finite and near one rotation only", _nearest_by_svd, STEPS)
ROTATION = Requirement(
    (3, 3), _is_rotation, "is not a rotation (off by more than 1e-6): repair it with nearest(R)", measures=DEFECTS
)
