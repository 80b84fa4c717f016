"""In your motion C stands still; it should move.

fails: special_motion_of_b, special_motion_of_c
names: the velocity of C vanishes
"""

_right_motion = special_motion


def special_motion(definition):
    if definition == "b":
        return [[0, 0, 1], [1, 0, 0]], [[0, 0, 0]]
    if definition == "c":
        return [[0, 0, 1], [1, 0, 0]], [[0, 0, 0]]
    return _right_motion(definition)
