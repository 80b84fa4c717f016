"""Matrices are multiplied element by element, by *; their product is @.

fails: space_sequence_takes_the_first_step_first, body_sequence_takes_the_axes_along, the_book_is_turned_in_both_orders
"""


def space_sequence(steps):
    R = np.eye(3)
    for axis, angle in steps:
        R = axis_rotation(axis, angle) * R
    return R


def body_sequence(steps):
    return space_sequence(steps)
