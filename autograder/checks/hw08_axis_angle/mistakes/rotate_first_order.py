"""Cos th taken for 1 where the angle is small.

fails: vector_turns_by_every_angle
within: 1e-14
"""

_right_rotate = rotate


def rotate(r, axis, angle):
    n = _unit(axis)
    return r + angle * np.cross(n, r) if abs(angle) < 1e-4 else _right_rotate(r, axis, angle)
