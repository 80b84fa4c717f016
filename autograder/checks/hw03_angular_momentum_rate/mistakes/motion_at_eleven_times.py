"""The property holds only at t = 0, 0.1, ..., 1, and not between them.

fails: special_motion_of_b
"""

_right_motion = special_motion


def special_motion(definition):
    if definition == "b":
        return [[0, 1, 0], *np.outer(np.polynomial.polynomial.polyint(np.poly(np.linspace(0, 1, 11))[::-1])[1:] * 1e3, [0, 0, 1])], [[0, 0, 0], [1, 0, 0], [1, 0, 0]]
    if definition == "c":
        return _right_motion("c")
    return _right_motion(definition)
