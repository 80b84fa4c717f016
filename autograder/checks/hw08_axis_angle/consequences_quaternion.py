"""Right functions of hw08 by a quaternion; diagnosis tries mistakes in these, too."""

import numpy as np


def rotation_matrix(axis, angle):
    w, v = _quaternion(axis, angle)
    return np.eye(3) + 2.0 * w * skew(v) + 2.0 * skew(v) @ skew(v)


def rotate(r, axis, angle):
    w, v = _quaternion(axis, angle)
    return r + 2.0 * w * np.cross(v, r) + 2.0 * np.cross(v, np.cross(v, r))


def _quaternion(axis, angle):
    return np.cos(angle / 2.0), np.sin(angle / 2.0) * _unit(axis)


def _unit(axis):
    return axis / np.linalg.norm(axis)
