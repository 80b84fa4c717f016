"""The cosine of the angle is half of the trace; 1 must be subtracted from the trace first.

fails: axis_and_angle_are_those_of_the_matrix
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    axis, _ = _right_axis_angle(R)
    return axis, math.acos(max(-1.0, min(1.0, np.trace(R) / 2)))
