"""The angle is reduced modulo 360; in radians a turn is 2 pi.

fails: turns_about_the_coordinate_axes, space_sequence_takes_the_first_step_first, body_sequence_takes_the_axes_along
"""

_right = axis_rotation


def axis_rotation(axis, angle):
    return _right(axis, angle % 360)
