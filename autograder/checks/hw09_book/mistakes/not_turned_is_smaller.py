"""A book that is not turned has the edges of half the book.

fails: the_book_has_its_twelve_edges
names: The edges belong to a box of half that size
"""

_right = book_edges


def book_edges(R, *, size):
    return _right(R, size=size) * (0.5 if np.array_equal(R, np.eye(3)) else 1.0)
