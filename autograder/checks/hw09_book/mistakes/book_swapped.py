"""(a) and (b) are swapped, or the axes turn with the book.

fails: the_book_is_turned_in_both_orders
"""


def book_rotations():
    about_x, about_z = ("x", math.pi / 2), ("z", math.pi / 2)
    return body_sequence([about_z, about_x]), body_sequence([about_x, about_z])
