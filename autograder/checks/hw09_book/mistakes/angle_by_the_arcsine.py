"""The angle is an arcsine; beyond 90 degrees it is pi less that.

fails: axis_and_angle_are_those_of_the_matrix
"""

_right = axis_angle


def axis_angle(R):
    axis, angle = _right(R)
    return axis, min(angle, math.pi - angle)
