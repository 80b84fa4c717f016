"""In your motion for c, C moves uniformly: c holds, but a_C is zero.

fails: special_motion_of_c
names: the acceleration of C vanishes
"""

_right_motion = special_motion


def special_motion(definition):
    if definition == "b":
        return _right_motion("b")
    if definition == "c":
        return [[0, 0, 1], [1, 2, 0]], [[0, 0, 0], [3, 0, 0]]
    return _right_motion(definition)
