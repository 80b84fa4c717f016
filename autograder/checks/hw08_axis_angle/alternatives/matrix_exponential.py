"""Show that the exponential of the skew matrix passes, complex numbers, tuples and lists."""

import cmath

import numpy as np
from scipy.linalg import expm


def skew(v):
    return tuple(map(tuple, np.cross(np.eye(3), np.asarray(v) * 1.0)))


def direction(axis):
    size = np.abs(axis).max()
    if not 0 < size < np.inf:
        raise ValueError
    n = axis / size
    return n / np.sqrt(n @ n)


def rotation_matrix(axis, angle):
    return expm(np.array(skew(direction(axis))) * angle)


def rotate(r, axis, angle):
    n = direction(axis)
    u = np.cross(n, np.eye(3)[np.argmin(np.abs(n))])
    u = u / np.linalg.norm(u)
    v = np.cross(n, u)
    z = complex(r @ u, r @ v) * cmath.exp(1j * angle)
    return list((r @ n) * n + z.real * u + z.imag * v)
