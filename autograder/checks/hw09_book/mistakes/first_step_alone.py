"""Only the first step is made: is the return inside of the loop?

fails: space_sequence_takes_the_first_step_first, body_sequence_takes_the_axes_along, the_book_is_turned_in_both_orders
"""


def space_sequence(steps):
    return axis_rotation(*steps[0]) if steps else np.eye(3)


def body_sequence(steps):
    return space_sequence(steps)
