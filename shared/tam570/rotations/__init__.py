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
- A matrix within 1e-6 of a rotation is taken for one, and the result is as far off as the matrix is;
  `nearest` repairs it.
- Wrong input raises ValueError with the argument's name, the offending value, and what to do.

Formulas: Shuster, A survey of attitude representations, J. Astronautical Sciences 41 (1993); Shepperd,
Quaternion from rotation matrix, J. Guidance and Control 1 (1978).
"""

import numpy as np
from numpy.typing import ArrayLike

from tam570.rotations import _euler, _formulas
from tam570.rotations._evaluate import Array, Component, Kind, argument, evaluate

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
    """
    return evaluate(_formulas.skew_of_vector, [argument("v", _VECTOR, v)], (3, 3))


def unskew(S: ArrayLike) -> Array:
    """The vector of a skew matrix; of any other matrix, that of its antisymmetric part (S - S^T)/2.

    S : (..., 3, 3)
    """
    return evaluate(_formulas.vector_of_skew, [argument("S", _MATRIX, S)], (3,))


def matrix_from_axis_angle(axis: ArrayLike, angle: ArrayLike) -> Array:
    """The matrix that turns by `angle` about `axis`.

    axis  : (..., 3), any nonzero length
    angle : (...), rad
    Raises ValueError if the axis is zero, or either is not finite.
    """
    arguments = [argument("axis", _AXIS, axis), argument("angle", _ANGLE, angle)]
    return evaluate(_formulas.matrix_of_axis_angle, arguments, (3, 3))


def axis_angle_from_matrix(R: ArrayLike) -> tuple[Array, Array]:
    """The unit axis (..., 3) and the angle (...) in [0, pi] of a rotation; full digits near 0 and pi.

    R : (..., 3, 3)
    Raises ValueError if R is not a rotation.
    """
    axis_and_angle = evaluate(_formulas.axis_angle_of_matrix, [argument("R", _ROTATION, R)], (4,))
    return axis_and_angle[..., :3], axis_and_angle[..., 3]


def matrix_from_quaternion(q: ArrayLike) -> Array:
    """The matrix of a quaternion.

    q : (..., 4), scalar first, any nonzero length
    Raises ValueError if q is zero or not finite.
    """
    return evaluate(_formulas.matrix_of_quaternion, [argument("q", _QUATERNION, q)], (3, 3))


def quaternion_from_matrix(R: ArrayLike) -> Array:
    """The unit quaternion (..., 4) of a rotation, scalar first and not negative.

    R : (..., 3, 3)
    Raises ValueError if R is not a rotation.
    """
    return evaluate(_formulas.quaternion_of_matrix, [argument("R", _ROTATION, R)], (4,))


def composition(p: ArrayLike, q: ArrayLike) -> Array:
    """The quaternion product p q: the rotation q followed by p (about space-fixed axes).

    p, q : (..., 4), scalar first; the length of the product is the product of the lengths
    Raises ValueError if p or q is zero or not finite.
    """
    arguments = [argument("p", _FACTOR, p), argument("q", _FACTOR, q)]
    return evaluate(_formulas.product_of_quaternions, arguments, (4,))


def matrix_from_euler(sequence: str, angles: ArrayLike) -> Array:
    """The matrix of three Euler angles about the body's axes in turn.

    sequence : "313", "312" or any other of the twelve
    angles   : (..., 3), rad
    Raises ValueError if there is no such sequence or an angle is not finite.
    """
    formula = _euler.matrix_of_angles(_order(sequence))
    return evaluate(formula, [argument("angles", _ANGLES, angles)], (3, 3))


def euler_from_matrix(sequence: str, R: ArrayLike) -> Array:
    """The three Euler angles (..., 3) of a rotation; they rebuild R to the last digits in gimbal lock too.

    sequence : "313", "312" or any other of the twelve
    R        : (..., 3, 3)
    Raises ValueError if there is no such sequence or R is not a rotation.
    """
    return evaluate(_euler.angles_of_matrix(_order(sequence)), [argument("R", _ROTATION, R)], (3,))


def euler_rates(sequence: str, angles: ArrayLike, omega: ArrayLike) -> Array:
    """The rates (..., 3) of three Euler angles of a body that turns at `omega`.

    sequence : "313", "312" or any other of the twelve
    angles   : (..., 3), rad
    omega    : (..., 3), rad/s, components along the body's axes (for components in space give R^T omega)
    Raises ValueError in gimbal lock: |sin b| < 1e-12 ("313"), |cos b| < 1e-12 ("312").
    """
    arguments = [argument("angles", _ANGLES, angles), argument("omega", _VECTOR, omega)]
    result = evaluate(_euler.rates(_order(sequence)), arguments, (4,))
    if (np.abs(result[..., 3]) < LOCK).any():
        raise ValueError(
            f"angles in gimbal lock: no rates of {sequence} there; take another sequence or a matrix"
        )
    return result[..., :3]


def exp(v: ArrayLike) -> Array:
    """The matrix of a rotation vector: exp(skew(v)), a turn by |v| about v.

    v : (..., 3), rad
    Raises ValueError if v is not finite.
    """
    return evaluate(_formulas.matrix_of_vector, [argument("v", _TURN, v)], (3, 3))


def log(R: ArrayLike) -> Array:
    """The rotation vector (..., 3) of a rotation, no longer than pi; exp(log(R)) = R.

    R : (..., 3, 3)
    Raises ValueError if R is not a rotation.
    """
    return evaluate(_formulas.vector_of_matrix, [argument("R", _ROTATION, R)], (3,))


def nearest(M: ArrayLike) -> Array:
    """The rotation nearest to M: the one with the smallest sum of squared differences.

    M : (..., 3, 3), any matrix, of either handedness
    Raises ValueError if M is not finite or several rotations are equally near.
    """
    matrices = argument("M", _MATRIX, M).value
    if not np.isfinite(matrices).all():
        raise ValueError("M is not finite")
    U, stretch, Vt = np.linalg.svd(matrices)
    U[..., 2] *= np.sign(np.linalg.det(U) * np.linalg.det(Vt))[..., None]
    return np.asarray(U @ Vt)


def _order(sequence: str) -> _euler.Sequence:
    if sequence not in SEQUENCES:
        raise ValueError(f"sequence {sequence!r} is none of the twelve: {', '.join(sorted(SEQUENCES))}")
    return SEQUENCES[sequence]


def _size(*components: Component) -> Component:
    """Zero or more for finite components, not a number or infinite otherwise."""
    return sum(abs(c) for c in components)


def _into_range(rows: Array) -> Array:
    """Rows scaled by powers of two, exactly, to a largest component in [1/2, 1)."""
    _, exponent = np.frexp(np.abs(rows).max(axis=1, keepdims=True))
    return np.asarray(np.ldexp(rows, -exponent))


_FINITE = "must be finite"
_DIRECTION = "must be finite and not zero"
_VECTOR = Kind((3,), _size, 0.0, np.finfo(float).max, _FINITE)
_MATRIX = Kind((3, 3), _size, 0.0, np.finfo(float).max, _FINITE)
_ANGLE = Kind((), _size, 0.0, np.finfo(float).max, _FINITE)
_ANGLES = _VECTOR
_TURN = Kind((3,), _formulas.square, 0.0, 1e300, "must be finite and shorter than 1e150 rad")
_AXIS = Kind(
    (3,), _formulas.square, 1e-200, 1e200, f"{_DIRECTION}: give a vector along the axis", _into_range
)
_QUATERNION = Kind(
    (4,), _formulas.square, 1e-200, 1e200, f"{_DIRECTION}: (1, 0, 0, 0) is no turn", _into_range
)
_FACTOR = Kind((4,), _formulas.square, 1e-200, 1e200, f"{_DIRECTION}: give unit quaternions")
_ROTATION = Kind(
    (3, 3),
    _formulas.defect,
    0.0,
    1e-12,
    "is not a rotation (off by more than 1e-6): repair it with nearest(R)",
)
