"""Right: Rodrigues' formula with half angles, written element by element, lists as results."""
import math

import numpy as np


def skew(v):
    a, b, c = v
    return [[0, -c, b], [c, 0, -a], [-b, a, 0]]


def _unit(axis):
    big = max(abs(x) for x in axis)
    if not all(math.isfinite(x) for x in axis) or big == 0:
        raise ValueError("axis")
    a = [x / big for x in axis]
    n = math.sqrt(sum(x * x for x in a))
    return [x / n for x in a]


def rotation_matrix(axis, angle):
    x, y, z = _unit(axis)
    c, s = math.cos(angle), math.sin(angle)
    d = 2 * math.sin(angle / 2) ** 2
    return [
        [c + d * x * x, d * x * y - s * z, d * x * z + s * y],
        [d * y * x + s * z, c + d * y * y, d * y * z - s * x],
        [d * z * x - s * y, d * z * y + s * x, c + d * z * z],
    ]


def rotate(r, axis, angle):
    n = np.array(_unit(axis))
    return math.cos(angle) * r + (1 - math.cos(angle)) * (n @ r) * n + math.sin(angle) * np.cross(n, r)
