"""Right functions of hw08 by powers of skew(axis); diagnosis tries mistakes in these, too."""

import numpy as np


def rotation_matrix(axis, angle):
    length, K = np.linalg.norm(axis), skew(axis)
    return np.eye(3) + np.sin(angle) * K / length + (1.0 - np.cos(angle)) * K @ K / length**2


def rotate(r, axis, angle):
    """Multiply by the matrix, whose mistake it shares."""
    return rotation_matrix(axis, angle) @ r
