"""The angle reduced modulo pi.

fails: matrix_turns_by_the_right_hand_rule
"""

import math

_right = rotation_matrix


def rotation_matrix(axis, angle):
    return _right(axis, math.fmod(angle, math.pi))
