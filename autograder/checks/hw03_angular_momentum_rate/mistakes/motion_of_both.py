"""In your motion both definitions hold, as all happens on one line; only one should.

fails: special_motion_of_b, special_motion_of_c
names: has rate = moment, too, along the motion
"""

_right_motion = special_motion


def special_motion(definition):
    if definition == "b":
        return [[5, 0, 0], [2, 0, 0]], [[0, 0, 0], [1, 0, 0], [1, 0, 0]]
    if definition == "c":
        return [[5, 0, 0], [2, 0, 0]], [[0, 0, 0], [1, 0, 0], [1, 0, 0]]
    return _right_motion(definition)
