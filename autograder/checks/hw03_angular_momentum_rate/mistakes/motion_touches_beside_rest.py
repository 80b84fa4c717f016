"""P rests where C passes halfway; turned round, the coefficients would do, but they are in order.

fails: special_motion_of_b
names: P and C meet at t = 0.5
"""

_right_motion = special_motion


def special_motion(definition):
    if definition == "b":
        return [[0, 0, 0]], [[-0.5, -0.25, 0], [1, 0, 0], [0, 1, 0]]
    return _right_motion(definition)
