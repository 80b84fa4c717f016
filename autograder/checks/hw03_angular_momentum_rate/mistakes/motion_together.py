"""In your motion P and C move together; they should not.

fails: special_motion_of_b, special_motion_of_c
names: P moves along with C
"""

_right_motion = special_motion


def special_motion(definition):
    if definition == "b":
        return [[0, 1, 0], [1, 0, 0], [1, 0, 0]], [[0, 0, 0], [1, 0, 0], [1, 0, 0]]
    if definition == "c":
        return [[0, 1, 0], [1, 0, 0], [0, -1, 0]], [[0, 0, 0], [1, 0, 0], [0, -1, 0]]
    return _right_motion(definition)
