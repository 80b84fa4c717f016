"""Right: the angle by arctan2 of the skew part and the trace, the axis by the symmetric part beyond 2 rad."""
import math

import numpy as np


def axis_rotation(axis, angle):
    c, s = math.cos(angle), math.sin(angle)
    if axis == "x":
        return [[1, 0, 0], [0, c, -s], [0, s, c]]
    if axis == "y":
        return [[c, 0, s], [0, 1, 0], [-s, 0, c]]
    if axis == "z":
        return [[c, -s, 0], [s, c, 0], [0, 0, 1]]
    raise ValueError(axis)


def space_sequence(steps):
    R = np.eye(3)
    for axis, angle in steps:
        R = np.array(axis_rotation(axis, angle)) @ R
    return R


def body_sequence(steps):
    R = np.eye(3)
    for axis, angle in steps:
        R = R @ np.array(axis_rotation(axis, angle))
    return R


def book_rotations():
    z, x = ("z", math.pi / 2), ("x", math.pi / 2)
    return space_sequence([z, x]), space_sequence([x, z])


def book_edges(R, *, size):
    a, b, c = [s / 2 for s in size]
    edges = []
    for u in (-1, 1):
        for v in (-1, 1):
            edges.append([(-a, u * b, v * c), (a, u * b, v * c)])
            edges.append([(u * a, -b, v * c), (u * a, b, v * c)])
            edges.append([(u * a, v * b, -c), (u * a, v * b, c)])
    return np.array(edges) @ np.transpose(R)


def axis_angle(R):
    R = np.asarray(R, dtype=float)
    if not np.all(np.isfinite(R)) or np.max(abs(R.T @ R - np.eye(3))) > 1e-6 or np.linalg.det(R) < 0:
        raise ValueError("not a rotation")
    w = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    angle = math.atan2(np.linalg.norm(w), np.trace(R) - 1)
    if angle < 2:
        n = np.linalg.norm(w)
        return (w / n if n > 0 else np.array([0.0, 0, 1])), angle
    S = (R + R.T) / 2 - math.cos(angle) * np.eye(3)  # (1 - cos) n n^T
    n = S[:, np.argmax(np.diag(S))]
    n = n / np.linalg.norm(n)
    return (n if n @ w >= 0 else -n), angle
