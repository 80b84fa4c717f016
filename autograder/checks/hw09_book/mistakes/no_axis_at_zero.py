"""The identity gets a zero axis; it should get a unit vector.

fails: no_turn_has_a_unit_axis, what_is_no_rotation_is_refused
names: the axis is the zero vector for the identity
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    return (n, angle) if angle > 0 else (0 * n, angle)
