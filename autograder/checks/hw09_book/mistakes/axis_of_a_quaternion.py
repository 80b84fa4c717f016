"""The axis is the vector of the quaternion, of the length sin(angle/2).

fails: axis_and_angle_are_those_of_the_matrix
names: its length is not 1
"""

_right = axis_angle


def axis_angle(R):
    n, angle = _right(R)
    return math.sin(angle / 2) * n, angle
