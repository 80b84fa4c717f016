"""y turns the other way: about y the order is z, x, not x, z.

fails: turns_about_the_coordinate_axes, space_sequence_takes_the_first_step_first, body_sequence_takes_the_axes_along
"""

_right = axis_rotation


def axis_rotation(axis, angle):
    return _right(axis, angle).T if axis == "y" else _right(axis, angle)
