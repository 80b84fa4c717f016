"""Half of the angle.

fails: vector_turns_by_the_right_hand_rule
"""

_right_rotate = rotate


def rotate(r, axis, angle):
    return _right_rotate(r, axis, angle / 2)
