"""hw09: Finite rotations do not commute.

figure.svg, beside this file, shows the axes, the names and the positive senses.

A rotation matrix acts on column vectors, r' = R r; angles are in radians and right-handed about their axis.
A sequence of rotations is a list of steps (axis, angle), first step first, where axis is "x", "y" or "z".

Off limits in this file: scipy.spatial.transform, tam570.rotations and tam570.lectures, which would answer it.
"""

import numpy as np

__all__ = ["axis_angle", "axis_rotation", "body_sequence", "book_edges", "book_rotations", "space_sequence"]


def axis_rotation(axis, angle):
    """Matrix that turns vectors by `angle` about a coordinate axis.

    axis  : "x", "y" or "z"
    angle : rad
    Returns (3, 3).
    Raises ValueError for any other string.
    """
    raise NotImplementedError


def space_sequence(steps):
    """Matrix of rotations one after the other, about axes that are fixed in space.

    steps : list of (axis, angle), first step first
    Returns (3, 3), the identity for no steps.
    """
    raise NotImplementedError


def body_sequence(steps):
    """Matrix of rotations one after the other, about axes that turn with the body.

    steps : list of (axis, angle), first step first
    Returns (3, 3), the identity for no steps.
    """
    raise NotImplementedError


def book_rotations():
    """The two turns of the book, about axes fixed in space.

    Returns (R_a, R_b), (3, 3) each: (a) 90 degrees about z and then about x, (b) about x and then about z.
    """
    raise NotImplementedError


def axis_angle(R):
    """Axis and angle of a rotation, to full digits near 0 and near pi too.

    R : (3, 3)
    Returns (axis (3,), angle): a unit vector, and 0 <= angle <= pi. Any unit axis at 0, either sign at pi.
    Raises ValueError if R is no rotation: max abs(R^T R - I) > 1e-6, det R < 0, or not finite.
    """
    raise NotImplementedError


def book_edges(R, *, size):
    """Edges of a book that is centred on the origin, turned by R.

    R    : (3, 3)
    size : (3,) m, lengths along x, y and z before the turn
    Returns (12, 2, 3) m: segment i runs from [i, 0] to [i, 1].
    """
    raise NotImplementedError
