"""Spaces around the axis's letter are accepted; they should be refused.

fails: other_axes_are_refused
names: ValueError for the string "x "
"""

_right = axis_rotation


def axis_rotation(axis, angle):
    return _right(axis.strip(), angle)
