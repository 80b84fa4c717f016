"""Right: the exponential of the skew matrix, and numbers in tuples."""

import numpy as np
from scipy.linalg import expm


def skew(v):
    return tuple(map(tuple, np.cross(np.eye(3), np.asarray(v) * 1.0)))


def rotation_matrix(axis, angle):
    size = np.abs(axis).max()
    if not 0 < size < np.inf:
        raise ValueError
    n = axis / size
    return expm(np.array(skew(n)) * (angle / np.sqrt(n @ n)))


def rotate(r, axis, angle):
    return list(np.einsum("ij,j->i", rotation_matrix(axis, angle), r))
