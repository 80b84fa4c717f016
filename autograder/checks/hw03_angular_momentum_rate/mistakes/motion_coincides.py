"""In your motion P is always at C; they should be apart.

fails: special_motion_of_b, special_motion_of_c
names: P and C meet at t = 0
"""

_right_motion = special_motion


def special_motion(definition):
    if definition == "b":
        return [[0, 0, 0], [1, 0, 0], [1, 0, 0]], [[0, 0, 0], [1, 0, 0], [1, 0, 0]]
    if definition == "c":
        return [[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    return _right_motion(definition)
