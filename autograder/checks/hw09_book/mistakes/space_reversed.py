"""The order reversed: axes that turn with the body.

fails: space_sequence_takes_the_first_step_first, the_book_is_turned_in_both_orders
also: (a) and (b) swapped, or axes that turn with the book
"""


def space_sequence(steps):
    return body_sequence(steps)
