"""Beyond 2 rad, the axis by positive roots of the diagonal, with one sign for all of it.

fails: axis_and_angle_are_those_of_the_matrix
names: the sizes of its components are right, their signs are not
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    return math.copysign(1, n.sum()) * np.abs(n) if angle > 2 else n, angle
