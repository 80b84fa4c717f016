"""The axis is R - R^T divided by its length, zero by zero for the identity.

fails: no_turn_has_a_unit_axis, what_is_no_rotation_is_refused
names: returned NaN or infinity for the identity
"""

_right_axis_angle = axis_angle


def axis_angle(R):
    n, angle = _right_axis_angle(R)
    return (n, angle) if angle > 0 else (np.full(3, np.nan), angle)
