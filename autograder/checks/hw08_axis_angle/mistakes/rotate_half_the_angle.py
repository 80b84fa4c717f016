"""A quaternion of a quarter of the angle: half of the turn.

fails: vector_turns_by_the_right_hand_rule
suspect: half of the angle
"""

_right_rotate = rotate


def rotate(r, axis, angle):
    return _right_rotate(r, axis, angle / 2)
