"""Cos th taken for 1 where the angle is small.

fails: matrix_holds_for_every_angle
within: 1e-14
"""

_right_rotation_matrix = rotation_matrix


def rotation_matrix(axis, angle):
    n = _unit(axis)
    return np.eye(3) + angle * skew(n) if abs(angle) < 1e-4 else _right_rotation_matrix(axis, angle)
