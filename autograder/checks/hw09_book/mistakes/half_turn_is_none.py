"""A turn is taken for none where the sine is zero: at a half turn too.

fails: turns_about_the_coordinate_axes, space_sequence_takes_the_first_step_first, body_sequence_takes_the_axes_along
names: for a half turn about x; a half turn is taken for no turn
"""

_right = axis_rotation


def axis_rotation(axis, angle):
    return _right(axis, angle if abs(math.sin(angle)) > 1e-15 else 0.0)
