"""A quarter turn of the book is by 1.5708 rad; pi/2 has more digits.

fails: the_book_is_turned_in_both_orders
names: which number has too few digits
"""


def book_rotations():
    about_x, about_z = ("x", 1.5708), ("z", 1.5708)
    return space_sequence([about_z, about_x]), space_sequence([about_x, about_z])
