"""The zero vector is returned before the axis is looked at.

fails: rotate_refuses_what_is_no_axis
names: does not raise ValueError for the zero axis, the zero vector
"""

_right_rotate = rotate


def rotate(r, axis, angle):
    return _right_rotate(r, axis, angle) if np.any(r) else np.zeros(3)
