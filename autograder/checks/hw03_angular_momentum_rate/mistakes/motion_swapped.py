"""The motions of b and c are swapped.

fails: special_motion_of_b, special_motion_of_c
names: by definition c they are equal
"""

_right_motion = special_motion


def special_motion(definition):
    if definition == "b":
        return _right_motion("c")
    if definition == "c":
        return _right_motion("b")
    return _right_motion(definition)
