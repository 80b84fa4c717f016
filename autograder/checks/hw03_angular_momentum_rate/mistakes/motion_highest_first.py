"""The coefficients begin with the highest power; they should begin with the constant.

fails: special_motion_of_b, special_motion_of_c
names: the sum starts at j = 0
"""

_right_motion = special_motion


def special_motion(definition):
    p, c = _right_motion(definition)
    return p[::-1], c[::-1]
