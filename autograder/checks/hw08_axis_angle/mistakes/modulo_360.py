"""The angle reduced modulo 360, which is no whole number of turns in radians.

fails: matrix_turns_by_the_right_hand_rule
"""

_right = rotation_matrix


def rotation_matrix(axis, angle):
    return _right(axis, angle % 360)
