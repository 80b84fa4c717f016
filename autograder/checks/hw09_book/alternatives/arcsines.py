"""Right: arcsine where the cosine is flat, arccosine where the sine is; products of turned columns."""

import math

import numpy as np

ORDER = {"x": (1, 2, 0), "y": (2, 0, 1), "z": (0, 1, 2)}


def axis_rotation(axis, angle):
    try:
        i, j, k = ORDER[axis]
    except KeyError:
        raise ValueError("x, y or z") from None
    R = np.zeros((3, 3))
    R[k, k] = 1
    R[i, i], R[i, j], R[j, i], R[j, j] = math.cos(angle), -math.sin(angle), math.sin(angle), math.cos(angle)
    return R.tolist()


def space_sequence(steps):
    columns = [np.array(e) for e in ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0))]
    for axis, angle in steps:
        columns = [np.array(axis_rotation(axis, angle)) @ column for column in columns]
    return np.transpose(columns)


def body_sequence(steps):
    return space_sequence(list(steps)[::-1])


def book_rotations():
    steps = [("z", np.pi / 2), ("x", np.pi / 2)]
    return tuple(tuple(map(tuple, sequence(steps))) for sequence in (space_sequence, body_sequence))


def axis_angle(R):
    if not np.all(np.isfinite(R)):
        raise ValueError("not finite")
    defect = np.max(np.abs(np.dot(np.transpose(R), R) - np.identity(3)))
    if defect > 1e-6 or np.dot(np.cross(R[0], R[1]), R[2]) < 0:
        raise ValueError(f"not a rotation: {defect}")
    v = np.array([R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]]) / 2
    cosine, sine = (R[0][0] + R[1][1] + R[2][2] - 1) / 2, min(math.hypot(*v), 1.0)
    if cosine > 0.7:
        return (v / sine if sine > 0 else np.array([1.0, 0, 0])), math.asin(sine)
    angle = math.acos(cosine) if cosine > -0.7 else math.pi - math.asin(sine)
    if cosine > -0.3:
        return v / np.linalg.norm(v), angle
    k = int(np.argmax([R[0][0], R[1][1], R[2][2]]))
    n = (np.asarray(R)[:, k] + np.asarray(R)[k]) / 2
    n[k] -= cosine
    n /= np.linalg.norm(n)
    return (n if np.dot(n, v) >= 0 else -n), angle


def book_edges(R, *, size):
    a, b, c = (np.array(R)[:, k] * size[k] for k in range(3))
    start = -(a + b + c) / 2
    edges = []
    for u, v, w in ((a, b, c), (b, c, a), (c, a, b)):
        for corner in (start, start + v, start + w, start + v + w):
            edges.append((corner + u, corner))
    return edges
