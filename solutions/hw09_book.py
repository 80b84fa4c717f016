"""hw09: Finite rotations do not commute.

figure.svg, beside this file, shows the axes, the names and the positive senses.

A rotation matrix acts on column vectors, r' = R r; angles are in radians and right-handed about their axis.
A sequence of rotations is a list of steps (axis, angle), first step first, where axis is "x", "y" or "z".

Off limits in this file: scipy.spatial.transform, tam570.rotations and tam570.lectures, which would answer it.
"""

import math

import numpy as np

__all__ = ["axis_angle", "axis_rotation", "body_sequence", "book_edges", "book_rotations", "space_sequence"]


def axis_rotation(axis, angle):
    """Matrix that turns vectors by `angle` about a coordinate axis.

    axis  : "x", "y" or "z"
    angle : rad
    Returns (3, 3).
    Raises ValueError for any other string.
    """
    if axis not in ("x", "y", "z"):
        raise ValueError(f'an axis is "x", "y" or "z", and not {axis!r}')
    k = "xyz".index(axis)
    i, j = (k + 1) % 3, (k + 2) % 3  # the turn takes axis i towards axis j
    R = np.eye(3)
    R[i, i] = R[j, j] = math.cos(angle)
    R[j, i] = math.sin(angle)
    R[i, j] = -R[j, i]
    return R


def space_sequence(steps):
    """Matrix of rotations one after the other, about axes that are fixed in space.

    steps : list of (axis, angle), first step first
    Returns (3, 3), the identity for no steps.
    """
    R = np.eye(3)
    for axis, angle in steps:
        R = axis_rotation(axis, angle) @ R
    return R


def body_sequence(steps):
    """Matrix of rotations one after the other, about axes that turn with the body.

    steps : list of (axis, angle), first step first
    Returns (3, 3), the identity for no steps.
    """
    # In the body's own components, the turns so far have changed nothing: the new turn acts on the vector first.
    R = np.eye(3)
    for axis, angle in steps:
        R = R @ axis_rotation(axis, angle)
    return R


def book_rotations():
    """The two turns of the book, about axes fixed in space.

    Returns (R_a, R_b), (3, 3) each: (a) 90 degrees about z and then about x, (b) about x and then about z.
    """
    about_x, about_z = ("x", math.pi / 2), ("z", math.pi / 2)
    return space_sequence([about_z, about_x]), space_sequence([about_x, about_z])


def axis_angle(R):
    """Axis and angle of a rotation, to full digits near 0 and near pi too.

    R : (3, 3)
    Returns (axis (3,), angle): a unit vector, and 0 <= angle <= pi. Any unit axis at 0, either sign at pi.
    Raises ValueError if R is no rotation: max abs(R^T R - I) > 1e-6, det R < 0, or not finite.
    """
    R = _rotation(R)
    # The antisymmetric part is sin th [n x], the symmetric one cos th I + (1 - cos th) n n^T.
    twice_sine_n = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    twice_sine, twice_cosine = math.hypot(*twice_sine_n), np.trace(R) - 1.0
    angle = math.atan2(twice_sine, twice_cosine)
    if twice_cosine < 0.0:  # sin th may be lost in rounding, 1 - cos th is at least 1
        return _column_axis(R + R.T - twice_cosine * np.eye(3), twice_sine_n), angle
    if twice_sine == 0.0:
        return np.array([1.0, 0.0, 0.0]), 0.0
    return twice_sine_n / twice_sine, angle


def book_edges(R, *, size):
    """Edges of a book that is centred on the origin, turned by R.

    R    : (3, 3)
    size : (3,) m, lengths along x, y and z before the turn
    Returns (12, 2, 3) m: segment i runs from [i, 0] to [i, 1].
    """
    half = 0.5 * np.asarray(size, dtype=float)
    edges = [
        (corner, corner * (1.0 - 2.0 * np.eye(3)[k])) for k in range(3) for corner in half * _CORNERS if corner[k] < 0.0
    ]
    return np.array(edges) @ np.asarray(R, dtype=float).T


_CORNERS = np.array([(x, y, z) for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])


def _rotation(R):
    """R as an array, if it is a rotation."""
    R = np.asarray(R, dtype=float)
    # The first test is false for a NaN, and keeps R^T R from overflow; no element of a rotation exceeds 1.
    if not (np.abs(R).max() < 2.0 and np.abs(R.T @ R - np.eye(3)).max() <= 1e-6 and np.linalg.det(R) > 0.0):
        raise ValueError("R is no rotation: R^T R = I and det R = 1 do not hold within 1e-6")
    return R


def _column_axis(multiple_of_nn, twice_sine_n):
    """Unit vector n from a multiple of n n^T: its longest column, with the sign of sin th n."""
    column = multiple_of_nn[:, np.argmax(np.diag(multiple_of_nn))]
    return math.copysign(1.0, column @ twice_sine_n) * column / math.hypot(*column)
