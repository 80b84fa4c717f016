"""The angle is that of the quaternion.

fails: axis_and_angle_are_those_of_the_matrix
names: it is half of the angle
"""

_right = axis_angle


def axis_angle(R):
    n, angle = _right(R)
    return n, angle / 2
