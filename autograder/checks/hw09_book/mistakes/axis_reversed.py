"""The axis is reversed: it is the axis of the transpose.

fails: axis_and_angle_are_those_of_the_matrix
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    return -n, angle
