"""Right functions of hw08 by powers of skew(n), in which a student may make one mistake."""

import numpy as np


def rotation_matrix(axis, angle):
    K = skew(_unit(axis))
    return np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K


def rotate(r, axis, angle):
    """Share a mistake of the matrix."""
    return rotation_matrix(axis, angle) @ r
