"""In your motion P and C meet at t = 0.5; they should stay apart.

fails: special_motion_of_b, special_motion_of_c
names: P and C meet at t = 0.5
"""

_right_motion = special_motion


def special_motion(definition):
    if definition == "b":
        return [[0.75, 0, 0]], [[0, 0, 0], [1, 0, 0], [1, 0, 0]]
    if definition == "c":
        return [[0, -0.5, 0], [1, 1, 0], [0, -1, 0]], [[0, 0, 0], [1, 0, 0], [0, -1, 0]]
    return _right_motion(definition)
