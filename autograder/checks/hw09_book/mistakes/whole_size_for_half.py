"""The corners are at the whole size from the centre; they should be at half of it.

fails: the_book_has_its_twelve_edges
names: a box of twice that size
"""

_right_edges = book_edges


def book_edges(R, *, size):
    return _right_edges(R, size=2 * size)
