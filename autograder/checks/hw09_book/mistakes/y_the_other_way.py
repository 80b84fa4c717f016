"""y turned the other way (z, x is the order about y, not x, z), in every turn.

fails: turns_about_the_coordinate_axes, space_sequence_takes_the_first_step_first, body_sequence_takes_the_axes_along
also: y turned the other way (z, x is the order about y, not x, z)
"""

_right = axis_rotation


def axis_rotation(axis, angle):
    return _right(axis, angle).T if axis == "y" else _right(axis, angle)
