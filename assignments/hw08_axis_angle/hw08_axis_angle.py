"""hw08: Axis and angle of a rotation, and its matrix.

figure.svg, beside this file, shows the axes, the names and the positive senses.

A rotation by the angle th about the unit vector n takes every r to

    r' = cos th r + (1 - cos th) (n . r) n + sin th n x r.

Off limits in this file: scipy.spatial.transform, tam570.rotations and tam570.lectures, which would answer it. In
rotate: rotation_matrix.
"""

import numpy as np

__all__ = ["rotate", "rotation_matrix", "skew"]


def skew(v):
    """Matrix of the cross product: skew(v) @ r equals v x r.

    v : (3,)
    Returns (3, 3).
    """
    raise NotImplementedError


def rotation_matrix(axis, angle):
    """Matrix that turns vectors by `angle` about `axis` (right-hand rule).

    axis  : (3,), any nonzero length
    angle : rad
    Returns (3, 3).
    Raises ValueError if the axis is zero or not finite.
    """
    raise NotImplementedError


def rotate(r, axis, angle):
    """The vector r turned by `angle` about `axis`, without forming the matrix.

    r     : (3,)
    axis  : (3,), any nonzero length
    angle : rad
    Returns (3,).
    Raises ValueError if the axis is zero or not finite.
    """
    raise NotImplementedError
