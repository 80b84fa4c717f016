"""In your motion C turns back at t = 0.3, and its acceleration changes sign at t = 0.7.

fails: special_motion_of_b, special_motion_of_c
names: the velocity of C vanishes at t = 0.3
"""

_right_motion = special_motion


def special_motion(definition):
    if definition == "b":
        return [[0, 1, 0]], [[0, 0, 0], [-0.6, 0, 0], [1, 0, 0]]
    if definition == "c":
        return [[0, 1, 0], [1, 2, 0], [0, -2.1, 0], [0, 1, 0]], [[0, 0, 0], [1, 0, 0], [0, -2.1, 0], [0, 1, 0]]
    return _right_motion(definition)
