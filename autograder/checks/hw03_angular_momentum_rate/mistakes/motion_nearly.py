"""The property holds only up to one part in a million; it should hold exactly.

fails: special_motion_of_b, special_motion_of_c
"""

_right_motion = special_motion


def special_motion(definition):
    if definition == "b":
        return [[0, 1, 0], [0, 1e-6, 0]], [[0, 0, 0], [1, 0, 0], [1, 0, 0]]
    if definition == "c":
        return [[0, 1, 0], [1, 1, 1e-6], [0, -1, 0]], [[0, 0, 0], [1, 0, 0], [0, -1, 0]]
    return _right_motion(definition)
