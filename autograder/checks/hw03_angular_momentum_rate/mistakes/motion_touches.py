"""In your motion C stops for an instant, as (t - 1/3)^2 does.

fails: special_motion_of_b
names: the velocity of C vanishes at t = 0.33
"""

_right_motion = special_motion


def special_motion(definition):
    if definition == "b":
        return [[0, 1, 0]], [[0, 0, 0], [1 / 9, 0, 0], [-1 / 3, 0, 0], [1 / 3, 0, 0]]
    if definition == "c":
        return _right_motion("c")
    return _right_motion(definition)
