"""Angles are reduced modulo 360.

fails: matrix_turns_by_the_right_hand_rule
suspect: modulo 360
"""

_right = rotation_matrix


def rotation_matrix(axis, angle):
    return _right(axis, angle % 360)
