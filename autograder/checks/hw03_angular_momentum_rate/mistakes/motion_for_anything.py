"""Any other letter gets the motion of c; it should be refused.

fails: special_motion_refuses_other_definitions
names: special_motion does not raise ValueError for the definition
"""

_right_motion = special_motion


def special_motion(definition):
    if definition == "b":
        return _right_motion("b")
    if definition == "c":
        return _right_motion("c")
    return _right_motion("c")
