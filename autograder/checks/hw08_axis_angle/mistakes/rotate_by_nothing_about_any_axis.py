"""The angle 0 leaves r as it is before the axis is looked at.

fails: rotate_refuses_what_is_no_axis
names: does not raise ValueError for the zero axis, no turn
"""

_right_rotate = rotate


def rotate(r, axis, angle):
    return r if angle == 0 else _right_rotate(r, axis, angle)
