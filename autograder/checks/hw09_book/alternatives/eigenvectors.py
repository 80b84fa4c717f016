"""Show that the axis as an eigenvector of R + R^T passes for large angles."""

from itertools import product

import numpy as np


def axis_rotation(axis, angle):
    c, s = np.cos(angle), np.sin(angle)
    matrices = {
        "x": [[1, 0, 0], [0, c, -s], [0, s, c]],
        "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }
    if axis not in matrices:
        raise ValueError("no such axis")
    return np.array(matrices[axis])


def space_sequence(steps):
    return np.linalg.multi_dot([axis_rotation(*step) for step in reversed(steps)] + [np.eye(3)] * 2)


def body_sequence(steps):
    """Turns about the images of the axes, each a turn S = R A R^T seen from space."""
    R = np.eye(3)
    for step in steps:
        R = (R @ axis_rotation(*step) @ R.T) @ R
    return R


def book_rotations():
    x, z = axis_rotation("x", np.pi / 2), axis_rotation("z", np.pi / 2)
    return x @ z, z @ x


def axis_angle(R):
    R = np.asarray(R)
    if not np.isfinite(R).all() or np.abs(R.T @ R - np.eye(3)).max() > 1e-6 or np.linalg.det(R) < 0:
        raise ValueError("no rotation")
    v = 0.5 * np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    sine = np.linalg.norm(v)
    angle = np.arctan2(sine, (np.trace(R) - 1) / 2)
    if angle > 1:
        n = np.linalg.eigh(R + R.T)[1][:, -1]
        return (-n if n @ v < 0 else n), angle
    if sine == 0:
        return np.array([0.0, 1.0, 0.0]), 0.0
    return v / sine, angle


def book_edges(R, *, size):
    corners = [np.array(signs) * size / 2 for signs in product((-1, 1), repeat=3)]
    return np.array(
        [
            (R @ a, R @ b)
            for i, a in enumerate(corners)
            for b in corners[i + 1 :]
            if np.count_nonzero(a != b) == 1
        ]
    )
