"""The size is turned, and the box drawn along the axes.

fails: the_book_has_its_twelve_edges
names: the size is turned, not the box
"""

_right_edges = book_edges


def book_edges(R, *, size):
    return _right_edges(np.eye(3), size=np.abs(R @ size))
