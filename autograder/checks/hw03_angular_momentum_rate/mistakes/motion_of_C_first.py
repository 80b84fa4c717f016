"""The motion of C comes before the motion of P; P should come first.

fails: special_motion_of_b
names: are P and C swapped
"""

_right_motion = special_motion


def special_motion(definition):
    p, c = _right_motion(definition)
    return c, p
