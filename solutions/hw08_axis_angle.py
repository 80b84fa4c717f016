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
    x, y, z = v
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def rotation_matrix(axis, angle):
    """Matrix that turns vectors by `angle` about `axis` (right-hand rule).

    axis  : (3,), any nonzero length
    angle : rad
    Returns (3, 3).
    Raises ValueError if the axis is zero or not finite.
    """
    n = _unit(axis)
    return np.cos(angle) * np.eye(3) + _versine(angle) * np.outer(n, n) + np.sin(angle) * skew(n)


def rotate(r, axis, angle):
    """The vector r turned by `angle` about `axis`, without forming the matrix.

    r     : (3,)
    axis  : (3,), any nonzero length
    angle : rad
    Returns (3,).
    Raises ValueError if the axis is zero or not finite.
    """
    n = _unit(axis)
    return np.cos(angle) * r + _versine(angle) * np.dot(n, r) * n + np.sin(angle) * skew(n) @ r


def _versine(angle):
    """1 - cos(angle), without the cancellation at small angles."""
    return 2.0 * np.sin(0.5 * angle) ** 2


def _unit(axis):
    """The unit vector along an axis; scaled first, so that no length over- or underflows."""
    axis = np.asarray(axis, dtype=float)
    largest = np.abs(axis).max()
    if not 0.0 < largest < np.inf:
        raise ValueError(f"a rotation axis must be finite and not zero, and this one is {axis}")
    scaled = axis / largest
    return scaled / np.sqrt(scaled @ scaled)
