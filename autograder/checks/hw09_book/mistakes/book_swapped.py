"""The book's turns are about axes that turn with it.

fails: the_book_is_turned_in_both_orders
suspect: (a) and (b) swapped
"""


def book_rotations():
    about_x, about_z = ("x", math.pi / 2), ("z", math.pi / 2)
    return body_sequence([about_z, about_x]), body_sequence([about_x, about_z])
