"""Only the exact identity is treated as no turn; next to it the axis is divided by zero.

fails: what_is_no_rotation_is_refused
names: NaN or infinity for the identity times 1 + 4.5e-7
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    if angle == 0 and not np.array_equal(R, np.eye(3)):
        n = np.zeros(3) / np.float64(0)
    return n, angle
