"""A half turn is treated as no turn: its sine is zero, but its cosine is -1.

fails: turns_about_the_coordinate_axes, space_sequence_takes_the_first_step_first, body_sequence_takes_the_axes_along
"""

_right = axis_rotation


def axis_rotation(axis, angle):
    return _right(axis, angle if abs(math.sin(angle)) > 1e-15 else 0.0)
