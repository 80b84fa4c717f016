"""The angle is in degrees; it should be in radians.

fails: axis_and_angle_are_those_of_the_matrix
"""

_right = axis_angle


def axis_angle(R):
    n, angle = _right(R)
    return n, math.degrees(angle)
