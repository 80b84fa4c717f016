"""The formula of first order for angles below 1e-4.

fails: vector_turns_by_every_angle
suspect: cos th taken for 1 where the angle is small
"""

_right_rotate = rotate


def rotate(r, axis, angle):
    n = _unit(axis)
    return r + angle * np.cross(n, r) if abs(angle) < 1e-4 else _right_rotate(r, axis, angle)
