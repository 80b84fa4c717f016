"""Show that half angles pass, and the axis by singular values."""

import numpy as np


def axis_rotation(axis, angle):
    if axis not in tuple("xyz"):
        raise ValueError(f"no axis {axis}")
    n = np.array([axis == name for name in "xyz"], dtype=float)
    e = np.eye(3)
    return np.transpose(
        [np.cos(angle) * r + np.sin(angle) * np.cross(n, r) + (1 - np.cos(angle)) * n * (n @ r) for r in e]
    )


def body_sequence(steps):
    R = np.eye(3)
    for step in steps:
        R = R @ axis_rotation(*step)
    return R


def space_sequence(steps):
    return body_sequence(steps[::-1])


def book_rotations():
    x, z = ("x", np.pi / 2), ("z", np.pi / 2)
    return space_sequence([z, x]), space_sequence([x, z])


def axis_angle(R):
    difference = R - np.eye(3)
    if not np.isfinite(R).all() or np.abs(R.T @ R - np.eye(3)).max() > 1e-6 or np.linalg.det(R) < 0:
        raise ValueError("no rotation")
    v = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    angle = 2 * np.arctan2(np.linalg.norm(difference) / np.sqrt(8), np.sqrt(max(1 + np.trace(R), 0)) / 2)
    if angle < 1:
        return (v / np.linalg.norm(v) if v.any() else np.array([0.6, 0, 0.8])), angle
    n = np.linalg.svd(difference)[2][-1]
    if v @ n < 0:
        n = -n
    return n, np.arctan2(v @ n, np.trace(R) - 1)


def book_edges(R, *, size):
    half, ends = np.array(size) / 2, np.array([-1.0, 1.0])
    edges = []
    for k in range(3):
        for a in ends:
            for b in ends:
                along = [np.insert([a, b], k, end) for end in ends]
                edges.append([R @ (corner * half) for corner in along])
    return edges
