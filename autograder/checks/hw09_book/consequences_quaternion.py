"""Right functions of hw09 by quaternions; diagnosis tries mistakes in their product and matrix, too."""

import math

import numpy as np


def axis_rotation(axis, angle):
    return _matrix(_quaternion(axis, angle))


def space_sequence(steps):
    q = _quaternion("x", 0.0)
    for step in steps:
        q = _product(_quaternion(*step), q)
    return _matrix(q)


def body_sequence(steps):
    q = _quaternion("x", 0.0)
    for step in steps:
        q = _product(q, _quaternion(*step))
    return _matrix(q)


def _quaternion(axis, angle):
    return np.array([math.cos(angle / 2), *(math.sin(angle / 2) * np.eye(3)["xyz".index(axis)])])


def _product(p, q):
    a, b, c, d = p
    e, f, g, h = q
    scalar = a * e - b * f - c * g - d * h
    return np.array(
        [scalar, a * f + b * e + (c * h - d * g), a * g + c * e + (d * f - b * h), a * h + d * e + (b * g - c * f)]
    )


def _matrix(q):
    w, x, y, z = q
    return np.array(
        [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
    )
