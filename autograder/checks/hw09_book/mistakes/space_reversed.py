"""The order is reversed: these axes turn with the body.

fails: space_sequence_takes_the_first_step_first, the_book_is_turned_in_both_orders
also: (a) and (b) are swapped
"""


def space_sequence(steps):
    return body_sequence(steps)
