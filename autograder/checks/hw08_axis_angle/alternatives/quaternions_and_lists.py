"""Show that plain Python passes: a unit quaternion, lists for results."""

import math


def quaternion(axis, angle):
    length = math.hypot(*axis)
    if not 0 < length < 1e300:
        raise ValueError("no axis")
    s = math.sin(angle / 2) / length
    return math.cos(angle / 2), s * axis[0], s * axis[1], s * axis[2]


def skew(v):
    return [[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]]


def rotation_matrix(axis, angle):
    w, x, y, z = quaternion(axis, angle)
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def rotate(r, axis, angle):
    w, *q = quaternion(axis, angle)
    t = [2 * c for c in cross(q, r)]
    return tuple(ri + w * ti + ci for ri, ti, ci in zip(r, t, cross(q, t)))
