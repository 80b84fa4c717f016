"""Reference functions of hw09: vectors turned by hw08's formula; quaternions for the axis and angle of a matrix."""

import math

import numpy as np


def turned(n, angle):
    """Return the matrix of a unit axis and an angle, with 1 - cos computed without cancellation."""
    along = np.outer(n, 2 * math.sin(angle / 2) ** 2 * n)
    return math.cos(angle) * np.eye(3) + along + math.sin(angle) * np.cross(n, np.eye(3)).T


def axis_rotation(axis, angle):
    return turned(np.eye(3)["xyz".index(axis)], angle)


def space_sequence(steps):
    """Turn every column by the steps, first step first."""
    R = np.eye(3)
    for axis, angle in steps:
        R = axis_rotation(axis, angle) @ R
    return R


def body_sequence(steps):
    return space_sequence(steps[::-1])


def book_rotations():
    z_then_x = [("z", math.pi / 2), ("x", math.pi / 2)]
    return space_sequence(z_then_x), space_sequence(z_then_x[::-1])


def axis_angle(R):
    """Use the longest column of 4 q q^T, q the unit quaternion, which loses no digit at any angle (Shepperd 1978)."""
    trace, twice_sine_n = np.trace(R), np.cross(np.eye(3), R.T).sum(axis=0)
    vectors = R + R.T + (1 - trace) * np.eye(3)
    products = np.block([[1 + trace, twice_sine_n], [twice_sine_n[:, None], vectors]])
    q = products[np.argmax(np.diag(products))]
    q = -q if q[0] < 0 else q
    length = np.linalg.norm(q[1:])
    return q[1:] / length, 2 * math.atan2(length, q[0])
