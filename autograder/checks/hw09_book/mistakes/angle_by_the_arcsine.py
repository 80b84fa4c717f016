"""The angle is an arcsine, which is wrong beyond 90 degrees: there it is pi less the arcsine.

fails: axis_and_angle_are_those_of_the_matrix
"""

_right = axis_angle


def axis_angle(R):
    axis, angle = _right(R)
    return axis, min(angle, math.pi - angle)
