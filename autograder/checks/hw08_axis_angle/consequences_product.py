"""Right functions of hw08 by q r q*, which is no rotation if the quaternion is not of unit length."""

import numpy as np


def rotation_matrix(axis, angle):
    return np.column_stack([rotate(unit, axis, angle) for unit in np.eye(3)])


def rotate(r, axis, angle):
    w, v = np.cos(angle / 2.0), np.sin(angle / 2.0) * _unit(axis)
    return (w * w - v @ v) * r + 2.0 * w * np.cross(v, r) + 2.0 * v * (v @ r)


def _unit(axis):
    return axis / np.linalg.norm(axis)
