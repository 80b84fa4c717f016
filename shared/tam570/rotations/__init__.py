"""Rotations: matrices, axis and angle, quaternions, Euler angles, rotation vectors.

Conventions

- A matrix R turns column vectors: r' = R r. For a body it takes body components to space components.
- Angles are in radians, right-handed about their axis, and used without wrapping.
- An axis is a vector of any nonzero length. From a matrix: a unit axis and 0 <= angle <= pi; the axis is x
  at angle 0 and of either sign at pi. A rotation vector is axis times angle.
- A quaternion is (w, x, y, z) = (cos(angle/2), sin(angle/2) axis), scalar first; q and -q are the same
  rotation. Any nonzero length is accepted; from a matrix: length 1 and w >= 0.
  `composition(p, q)` turns by q, then by p, as R_p R_q does.
- Euler angles: a sequence "ijk" names the axes of three turns, 1, 2, 3 = x, y, z of the body, each as the turns
  before it have moved it: R = R_i(a) R_j(b) R_k(c). "313" is Rz(psi) Rx(theta) Rz(phi), "312" is Rz Rx Ry;
  turns by c, b, a about axes fixed in space give the same matrix. From a matrix: a and c in [-pi, pi],
  b in [0, pi] where the last axis is the first ("313"), else in [-pi/2, pi/2] ("312"). In gimbal lock, where
  only a + c or a - c is determined, a is 0.
- The angular velocity is in body axes: R' = R skew(omega).
- Functions take and return arrays; leading axes are batches and broadcast: (..., 3), (..., 4), (..., 3, 3).
- A matrix within 1e-6 of a rotation is accepted; the result has an error of the same size. `nearest` repairs it.
- Wrong input raises ValueError with the argument's name, the offending value, and what to do.

Formulas: Shuster, A survey of attitude representations, J. Astronautical Sciences 41 (1993); Shepperd,
Quaternion from rotation matrix, J. Guidance and Control 1 (1978).
"""

import numpy as np
from numpy.typing import ArrayLike

from tam570.rotations import _euler, _formulas, _stacked
from tam570.rotations._evaluate import Array, evaluate
from tam570.rotations._requirements import ANGLE, AXIS, FACTOR, MATRIX, NEAR_ONE, QUATERNION, ROTATION, TURN, VECTOR

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
    """Return the matrix of the cross product: skew(v) @ r is v x r.

    Parameters
    ----------
    v : (..., 3) array_like

    Returns
    -------
    (..., 3, 3) ndarray

    Raises
    ------
    ValueError
        If v is not finite.

    Examples
    --------
    >>> skew([1, 2, 3]) @ [0, 0, 1]
    array([ 2., -1.,  0.])
    """
    return evaluate(_formulas.skew_of_vector, (3, 3), ("v", VECTOR, v))


def unskew(S: ArrayLike) -> Array:
    """Return the vector of a skew matrix; of any other matrix, that of its antisymmetric part (S - S^T)/2.

    Parameters
    ----------
    S : (..., 3, 3) array_like

    Returns
    -------
    (..., 3) ndarray

    Raises
    ------
    ValueError
        If S is not finite.

    Examples
    --------
    >>> unskew(skew([1, 2, 3]))
    array([1., 2., 3.])
    """
    return evaluate(_formulas.vector_of_skew, (3,), ("S", MATRIX, S))


def matrix_from_axis_angle(axis: ArrayLike, angle: ArrayLike) -> Array:
    """Return the matrix that turns by `angle` about `axis`.

    Parameters
    ----------
    axis : (..., 3) array_like
        Of any nonzero length.
    angle : (...) array_like
        In rad, right-handed about the axis.

    Returns
    -------
    (..., 3, 3) ndarray

    Raises
    ------
    ValueError
        If the axis is zero, or either is not finite.

    Examples
    --------
    >>> (matrix_from_axis_angle([0, 0, 2], np.pi / 2) @ [1, 0, 0]).round(12)
    array([0., 1., 0.])
    """
    formula, stacked = _formulas.matrix_of_axis_angle, _stacked.matrix_of_axis_angle
    arguments = ("axis", AXIS, axis), ("angle", ANGLE, angle)
    return evaluate(formula, (3, 3), *arguments, stacked=stacked)


def axis_angle_from_matrix(R: ArrayLike) -> tuple[Array, Array]:
    """Return the unit axis and the angle of a rotation, with full digits near 0 and pi.

    Parameters
    ----------
    R : (..., 3, 3) array_like

    Returns
    -------
    axis : (..., 3) ndarray
        x at the angle 0, of either sign at pi.
    angle : (...) ndarray, or float for one rotation
        In rad, from 0 to pi.

    Raises
    ------
    ValueError
        If R is not a rotation.

    Examples
    --------
    >>> axis, angle = axis_angle_from_matrix([[0, 0, 1], [1, 0, 0], [0, 1, 0]])
    >>> axis.round(6), round(float(np.degrees(angle)), 9)
    (array([0.57735, 0.57735, 0.57735]), 120.0)
    """
    axis_and_angle = evaluate(_formulas.axis_angle_of_matrix, (4,), ("R", ROTATION, R))
    return axis_and_angle[..., :3], axis_and_angle[..., 3][()]  # a float for one rotation


def matrix_from_quaternion(q: ArrayLike) -> Array:
    """Return the matrix of a quaternion.

    Parameters
    ----------
    q : (..., 4) array_like
        Scalar first, of any nonzero length.

    Returns
    -------
    (..., 3, 3) ndarray

    Raises
    ------
    ValueError
        If q is zero or not finite.

    Examples
    --------
    >>> matrix_from_quaternion([1, 0, 0, 1]) @ [1, 0, 0]
    array([0., 1., 0.])
    """
    formula, stacked = _formulas.matrix_of_quaternion, _stacked.matrix_of_quaternion
    return evaluate(formula, (3, 3), ("q", QUATERNION, q), stacked=stacked)


def quaternion_from_matrix(R: ArrayLike) -> Array:
    """Return the unit quaternion of a rotation.

    Parameters
    ----------
    R : (..., 3, 3) array_like

    Returns
    -------
    (..., 4) ndarray
        Scalar first; the scalar is not negative.

    Raises
    ------
    ValueError
        If R is not a rotation.

    Examples
    --------
    >>> quaternion_from_matrix(np.diag([1, -1, -1]))
    array([0., 1., 0., 0.])
    """
    return evaluate(_formulas.quaternion_of_matrix, (4,), ("R", ROTATION, R))


def composition(p: ArrayLike, q: ArrayLike) -> Array:
    """Return the quaternion product p q: the rotation q followed by p, about axes fixed in space.

    Parameters
    ----------
    p, q : (..., 4) array_like
        Scalar first. The length of the product is the product of the lengths.

    Returns
    -------
    (..., 4) ndarray

    Raises
    ------
    ValueError
        If p or q is not finite.

    Examples
    --------
    >>> composition([0, 1, 0, 0], [0, 0, 1, 0])
    array([0., 0., 0., 1.])
    """
    return evaluate(_formulas.product_of_quaternions, (4,), ("p", FACTOR, p), ("q", FACTOR, q))


def matrix_from_euler(sequence: str, angles: ArrayLike) -> Array:
    """Return the matrix of three Euler angles about the body's axes in turn.

    Parameters
    ----------
    sequence : str
        "313", "312" or any other of the twelve.
    angles : (..., 3) array_like
        In rad.

    Returns
    -------
    (..., 3, 3) ndarray

    Raises
    ------
    ValueError
        If there is no such sequence, or an angle is not finite.

    Examples
    --------
    >>> matrix_from_euler("313", [np.pi / 6, 0, 0])[0].round(6)
    array([ 0.866025, -0.5     ,  0.      ])
    """
    formula = _euler.matrix_of_angles(_order(sequence))
    return evaluate(formula, (3, 3), ("angles", VECTOR, angles))


def euler_from_matrix(sequence: str, R: ArrayLike) -> Array:
    """Return the three Euler angles of a rotation; `matrix_from_euler` of them is R to rounding, in gimbal lock too.

    Parameters
    ----------
    sequence : str
        "313", "312" or any other of the twelve.
    R : (..., 3, 3) array_like

    Returns
    -------
    (..., 3) ndarray
        In rad. In gimbal lock the first angle is 0.

    Raises
    ------
    ValueError
        If there is no such sequence, or R is not a rotation.

    Examples
    --------
    >>> euler_from_matrix("312", matrix_from_euler("312", [0.1, 0.2, 0.3])).round(12)
    array([0.1, 0.2, 0.3])
    """
    formula = _euler.angles_of_matrix(_order(sequence))
    return evaluate(formula, (3,), ("R", ROTATION, R))


def euler_rates(sequence: str, angles: ArrayLike, omega: ArrayLike) -> Array:
    """Return the rates of three Euler angles of a body that turns at `omega`.

    Parameters
    ----------
    sequence : str
        "313", "312" or any other of the twelve.
    angles : (..., 3) array_like
        In rad.
    omega : (..., 3) array_like
        In rad/s, components along the body's axes; for components in space pass R^T omega.

    Returns
    -------
    (..., 3) ndarray
        In rad/s.

    Raises
    ------
    ValueError
        If there is no such sequence, an angle or omega is not finite, or in gimbal lock: abs(sin b) < 1e-12 ("313"),
        abs(cos b) < 1e-12 ("312").

    Examples
    --------
    >>> euler_rates("313", [0, np.pi / 2, 0], [0, 2, 1]).round(12)
    array([2., 0., 1.])
    """
    formula = _euler.rates(_order(sequence))
    result = evaluate(formula, (4,), ("angles", VECTOR, angles), ("omega", VECTOR, omega))
    if (np.abs(result[..., 3]) < LOCK).any():
        raise ValueError(f"angles in gimbal lock: no rates of {sequence} there; take another sequence or a matrix")
    return result[..., :3]


def exp(v: ArrayLike) -> Array:
    """Return the matrix of a rotation vector: a turn by its length about its direction, exp(skew(v)).

    Parameters
    ----------
    v : (..., 3) array_like
        In rad.

    Returns
    -------
    (..., 3, 3) ndarray

    Raises
    ------
    ValueError
        If v is not finite.

    Examples
    --------
    >>> np.diag(exp([np.pi, 0, 0])).round(12)
    array([ 1., -1., -1.])
    """
    formula, stacked = _formulas.matrix_of_vector, _stacked.matrix_of_vector
    return evaluate(formula, (3, 3), ("v", TURN, v), stacked=stacked)


def log(R: ArrayLike) -> Array:
    """Return the rotation vector of a rotation; exp(log(R)) is R.

    Parameters
    ----------
    R : (..., 3, 3) array_like

    Returns
    -------
    (..., 3) ndarray
        In rad, no longer than pi.

    Raises
    ------
    ValueError
        If R is not a rotation.

    Examples
    --------
    >>> log(exp([0.1, 0.2, 0.3])).round(12)
    array([0.1, 0.2, 0.3])
    """
    return evaluate(_formulas.vector_of_matrix, (3,), ("R", ROTATION, R))


def nearest(M: ArrayLike) -> Array:
    """Return the rotation nearest to M: the one with the smallest sum of squared differences.

    Parameters
    ----------
    M : (..., 3, 3) array_like
        Any matrix, of either handedness.

    Returns
    -------
    (..., 3, 3) ndarray

    Raises
    ------
    ValueError
        If M is not finite, or several rotations are equally near.

    Examples
    --------
    >>> nearest(1.001 * np.eye(3))
    array([[1., 0., 0.],
           [0., 1., 0.],
           [0., 0., 1.]])
    """
    return evaluate(_formulas.nearest_rotation, (3, 3), ("M", NEAR_ONE, M))


def _order(sequence: str) -> _euler.Sequence:
    if sequence not in SEQUENCES:
        raise ValueError(f"sequence {sequence!r} is unknown; the twelve are: {', '.join(sorted(SEQUENCES))}")
    return SEQUENCES[sequence]
