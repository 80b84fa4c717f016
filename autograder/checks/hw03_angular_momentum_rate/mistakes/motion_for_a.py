"""Definition a, which always holds, gets a motion too; it should be refused.

fails: special_motion_refuses_other_definitions
names: special_motion does not raise ValueError for the definition
"""

_right_motion = special_motion


def special_motion(definition):
    return _right_motion("b" if definition == "a" else definition)
