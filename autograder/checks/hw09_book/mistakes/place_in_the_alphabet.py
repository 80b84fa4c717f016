"""The axis is looked up in the string "xyz", where "", "xy" and "yz" are found too.

fails: other_axes_are_refused
names: ValueError for the string "xy"
"""

_right = axis_rotation


def axis_rotation(axis, angle):
    return _right("xyz"["xyz".index(axis)], angle)
