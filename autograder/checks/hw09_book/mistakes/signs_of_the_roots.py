"""Beyond 2 rad the components of the axis all have one sign.

fails: axis_and_angle_are_those_of_the_matrix
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    return math.copysign(1, n.sum()) * np.abs(n) if angle > 2 else n, angle
