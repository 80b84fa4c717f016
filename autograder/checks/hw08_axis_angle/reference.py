"""Reference functions of hw08, unlike the formula: a frame with the axis as third vector is turned."""

import numpy as np


def skew(v):
    return np.cross(v, np.eye(3)).T


def rotation_matrix(axis, angle):
    """Turn e towards f in a frame e, f, n that comes from a QR factorisation."""
    n = np.asarray(axis) / np.max(np.abs(axis))
    n = n / np.linalg.norm(n)
    e, f = np.linalg.qr(np.column_stack([n, np.eye(3)]))[0].T[1:]
    f = f * np.sign(np.dot(np.cross(e, f), n))
    c, s = np.cos(angle), np.sin(angle)
    return np.outer(n, n) + np.outer(c * e + s * f, e) + np.outer(c * f - s * e, f)


def rotate(r, axis, angle):
    return rotation_matrix(axis, angle) @ r
