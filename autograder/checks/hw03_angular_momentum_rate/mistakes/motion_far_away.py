"""In your motion P and C are so far from O that rounding would hide any error.

fails: special_motion_of_c
names: which product must vanish
"""

_right_motion = special_motion


def special_motion(definition):
    if definition == "c":  # r_{P/C} = 21 (1 + t) e_x, a_C = (1, 1, 1)
        c = np.array([[1e13, 0, 0], [1, 0, 3], [0.5, 0.5, 0.5]])
        return c + [[21, 0, 0], [21, 0, 0], [0, 0, 0]], c
    return _right_motion(definition)
