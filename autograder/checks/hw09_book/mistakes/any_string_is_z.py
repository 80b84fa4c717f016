"""Any string but x and y is treated as z; it should be refused.

fails: other_axes_are_refused
names: ValueError for the string "w"
"""

_right = axis_rotation


def axis_rotation(axis, angle):
    return _right(axis if axis in ("x", "y") else "z", angle)
