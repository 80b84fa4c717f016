"""The angle is half of the right one, as in a quaternion.

fails: axis_and_angle_are_those_of_the_matrix
"""

_right = axis_angle


def axis_angle(R):
    n, angle = _right(R)
    return n, angle / 2
