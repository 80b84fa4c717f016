"""Show that a rotation in a frame built on the axis passes, one column after another."""

import math

import numpy as np


def skew(v):
    return np.stack([np.cross(v, e) for e in np.eye(3)], axis=1)


def rotation_matrix(axis, angle):
    return np.column_stack([rotate(e, axis, angle) for e in np.eye(3)])


def rotate(r, axis, angle):
    axis = axis / np.max(np.abs(axis)) if np.any(axis) else axis
    length = math.sqrt(sum(x * x for x in axis))
    if not (length > 0 and math.isfinite(length)):
        raise ValueError("the axis has no direction")
    n = axis / length
    along = np.dot(r, n) * n
    across = r - along
    return [np.float64(x) for x in along + math.cos(angle) * across + math.sin(angle) * np.cross(n, across)]
