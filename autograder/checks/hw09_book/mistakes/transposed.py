"""Every turn goes the other way: the matrix is the transpose.

fails: turns_about_the_coordinate_axes, space_sequence_takes_the_first_step_first, body_sequence_takes_the_axes_along, the_book_is_turned_in_both_orders
"""

_right = axis_rotation


def axis_rotation(axis, angle):
    return _right(axis, -angle)
