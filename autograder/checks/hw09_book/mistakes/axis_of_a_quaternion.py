"""The axis is the vector of the quaternion, whose length is sin(angle/2); it should be 1.

fails: axis_and_angle_are_those_of_the_matrix
"""

_right = axis_angle


def axis_angle(R):
    n, angle = _right(R)
    return math.sin(angle / 2) * n, angle
