"""Rotations: matrices, axis and angle, quaternions, Euler angles, rotation vectors.

Conventions
- A matrix R turns column vectors: r' = R r. For a body it takes body components to space components.
- Angles are in radians, right-handed about their axis, never wrapped on the way in.
- An axis is a vector of any nonzero length. From a matrix: a unit axis and 0 <= angle <= pi; the axis is x
  at angle 0 and of either sign at pi. A rotation vector is axis times angle.
- A quaternion is (w, x, y, z) = (cos(angle/2), sin(angle/2) axis), scalar first; q and -q are the same
  rotation. Any nonzero length is taken; from a matrix: length 1 and w >= 0.
  `composition(p, q)` is first q, then p, as in R_p R_q.
- Euler angles: a sequence "ijk" names axes 1, 2, 3 = x, y, z of the body, turned about in that order, each as
  the turns before have left it: R = R_i(a) R_j(b) R_k(c). "313" is Rz(psi) Rx(theta) Rz(phi), "312" is
  Rz Rx Ry; the same matrix turns about axes fixed in space by c, b, a. From a matrix: a and c in [-pi, pi],
  b in [0, pi] where the last axis is the first ("313"), else in [-pi/2, pi/2] ("312"). In gimbal lock, where
  only a + c or a - c is determined, a is 0.
- The angular velocity is in body axes: R' = R skew(omega).
- Arrays in, arrays out; leading axes are batches and broadcast: (..., 3), (..., 4), (..., 3, 3).
- A matrix within 1e-6 of a rotation is accepted, and the result is as far off as the matrix is; `nearest` repairs it.
- Wrong input raises ValueError with the argument's name, the offending value, and what to do.

Formulas: Shuster, A survey of attitude representations, J. Astronautical Sciences 41 (1993); Shepperd,
Quaternion from rotation matrix, J. Guidance and Control 1 (1978).
"""

import numpy as np
from numpy.typing import ArrayLike

from tam570.rotations import _euler, _formulas, _kinds, _stacked
from tam570.rotations._evaluate import Array, evaluate

__all__ = [
    "axis_angle_from_matrix",
    "composition",
    "euler_from_matrix",
    "euler_rates",
    "exp",
    "log",
    "matrix_from_axis_angle",
    "matrix_from_euler",
    "matrix_from_quaternion",
    "nearest",
    "quaternion_from_matrix",
    "skew",
    "unskew",
]

SEQUENCES = _euler.sequences()
LOCK = 1e-12  # |sin b| ("313") or |cos b| ("312") below which the Euler rates are refused


def skew(v: ArrayLike) -> Array:
    """The matrix of v x: skew(v) r = v x r.

    v : (..., 3)
    Raises ValueError if v is not finite.
    """
    return evaluate(_formulas.skew_of_vector, _kinds.FINITE, (3, 3), ("v", _kinds.VECTOR, v))


def unskew(S: ArrayLike) -> Array:
    """The vector of a skew matrix; of any other matrix, that of its antisymmetric part (S - S^T)/2.

    S : (..., 3, 3)
    Raises ValueError if S is not finite.
    """
    return evaluate(_formulas.vector_of_skew, _kinds.FINITE, (3,), ("S", _kinds.MATRIX, S))


def matrix_from_axis_angle(axis: ArrayLike, angle: ArrayLike) -> Array:
    """The matrix that turns by `angle` about `axis`.

    axis  : (..., 3), any nonzero length
    angle : (...), rad
    Raises ValueError if the axis is zero, or either is not finite.
    """
    formula = _formulas.matrix_of_axis_angle
    return evaluate(
        formula,
        _kinds.SQUARES,
        (3, 3),
        ("axis", _kinds.AXIS, axis),
        ("angle", _kinds.ANGLE, angle),
        stacked=_stacked.matrix_of_axis_angle,
    )


def axis_angle_from_matrix(R: ArrayLike) -> tuple[Array, Array]:
    """The unit axis (..., 3) and the angle (...) in [0, pi] of a rotation; full digits near 0 and pi.

    R : (..., 3, 3)
    Raises ValueError if R is not a rotation.
    """
    axis_and_angle = evaluate(_formulas.axis_angle_of_matrix, _kinds.DEFECTS, (4,), ("R", _kinds.ROTATION, R))
    return axis_and_angle[..., :3], axis_and_angle[..., 3][()]  # of one rotation a float


def matrix_from_quaternion(q: ArrayLike) -> Array:
    """The matrix of a quaternion.

    q : (..., 4), scalar first, any nonzero length
    Raises ValueError if q is zero or not finite.
    """
    formula, stacked = _formulas.matrix_of_quaternion, _stacked.matrix_of_quaternion
    return evaluate(formula, _kinds.SQUARES, (3, 3), ("q", _kinds.QUATERNION, q), stacked=stacked)


def quaternion_from_matrix(R: ArrayLike) -> Array:
    """The unit quaternion (..., 4) of a rotation, scalar first and not negative.

    R : (..., 3, 3)
    Raises ValueError if R is not a rotation.
    """
    return evaluate(_formulas.quaternion_of_matrix, _kinds.DEFECTS, (4,), ("R", _kinds.ROTATION, R))


def composition(p: ArrayLike, q: ArrayLike) -> Array:
    """The quaternion product p q: the rotation q followed by p (about space-fixed axes).

    p, q : (..., 4), scalar first; the length of the product is the product of the lengths
    Raises ValueError if p or q is not finite.
    """
    return evaluate(
        _formulas.product_of_quaternions, _kinds.FINITE, (4,), ("p", _kinds.FACTOR, p), ("q", _kinds.FACTOR, q)
    )


def matrix_from_euler(sequence: str, angles: ArrayLike) -> Array:
    """The matrix of three Euler angles about the body's axes in turn.

    sequence : "313", "312" or any other of the twelve
    angles   : (..., 3), rad
    Raises ValueError if there is no such sequence or an angle is not finite.
    """
    formula = _euler.matrix_of_angles(_order(sequence))
    return evaluate(formula, _kinds.FINITE, (3, 3), ("angles", _kinds.VECTOR, angles))


def euler_from_matrix(sequence: str, R: ArrayLike) -> Array:
    """The three Euler angles (..., 3) of a rotation; they rebuild R to the last digits in gimbal lock too.

    sequence : "313", "312" or any other of the twelve
    R        : (..., 3, 3)
    Raises ValueError if there is no such sequence or R is not a rotation.
    """
    formula = _euler.angles_of_matrix(_order(sequence))
    return evaluate(formula, _kinds.DEFECTS, (3,), ("R", _kinds.ROTATION, R))


def euler_rates(sequence: str, angles: ArrayLike, omega: ArrayLike) -> Array:
    """The rates (..., 3) of three Euler angles of a body that turns at `omega`.

    sequence : "313", "312" or any other of the twelve
    angles   : (..., 3), rad
    omega    : (..., 3), rad/s, components along the body's axes (for components in space give R^T omega)
    Raises ValueError if there is no such sequence, an angle or omega is not finite, or in gimbal lock:
    |sin b| < 1e-12 ("313"), |cos b| < 1e-12 ("312").
    """
    formula = _euler.rates(_order(sequence))
    result = evaluate(formula, _kinds.FINITE, (4,), ("angles", _kinds.VECTOR, angles), ("omega", _kinds.VECTOR, omega))
    if (np.abs(result[..., 3]) < LOCK).any():
        raise ValueError(f"angles in gimbal lock: no rates of {sequence} there; take another sequence or a matrix")
    return result[..., :3]


def exp(v: ArrayLike) -> Array:
    """The matrix of a rotation vector: exp(skew(v)), a turn by |v| about v.

    v : (..., 3), rad
    Raises ValueError if v is not finite.
    """
    formula, stacked = _formulas.matrix_of_vector, _stacked.matrix_of_vector
    return evaluate(formula, _kinds.TURNS, (3, 3), ("v", _kinds.TURN, v), stacked=stacked)


def log(R: ArrayLike) -> Array:
    """The rotation vector (..., 3) of a rotation, no longer than pi; exp(log(R)) = R.

    R : (..., 3, 3)
    Raises ValueError if R is not a rotation.
    """
    return evaluate(_formulas.vector_of_matrix, _kinds.DEFECTS, (3,), ("R", _kinds.ROTATION, R))


def nearest(M: ArrayLike) -> Array:
    """The rotation nearest to M: the one with the smallest sum of squared differences.

    M : (..., 3, 3), any matrix, of either handedness
    Raises ValueError if M is not finite or several rotations are equally near.
    """
    return evaluate(_formulas.nearest_rotation, _kinds.STEPS, (3, 3), ("M", _kinds.NEAR_ONE, M))


def _order(sequence: str) -> _euler.Sequence:
    if sequence not in SEQUENCES:
        raise ValueError(f"sequence {sequence!r} is unknown; the twelve are: {', '.join(sorted(SEQUENCES))}")
    return SEQUENCES[sequence]
