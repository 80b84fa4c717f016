"""The book is turned by 90 radians; it should be turned by pi/2.

fails: the_book_is_turned_in_both_orders
"""


def book_rotations():
    about_x, about_z = ("x", 90), ("z", 90)
    return space_sequence([about_z, about_x]), space_sequence([about_x, about_z])
