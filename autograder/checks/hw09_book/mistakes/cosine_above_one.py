"""Your arccos gives NaN where rounding makes the trace larger than 3.

fails: what_is_no_rotation_is_refused
names: NaN or infinity for the identity times 1 + 4.5e-7
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    return n, np.arccos((np.trace(R) - 1) / 2) if angle == 0 else angle
