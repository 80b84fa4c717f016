"""(b) is given as the transpose of (a), which undoes (a); in (b) both turns go as in (a), in the other order.

fails: the_book_is_turned_in_both_orders
"""

_right_rotations = book_rotations


def book_rotations():
    R_a, _ = _right_rotations()
    return R_a, R_a.T
