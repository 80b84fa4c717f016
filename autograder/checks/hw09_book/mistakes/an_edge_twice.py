"""One edge is drawn twice, and another is missing.

fails: the_book_has_its_twelve_edges
names: is one drawn twice
"""

_right_edges = book_edges


def book_edges(R, *, size):
    edges = _right_edges(R, size=size)
    edges[7] = edges[3][::-1]
    return edges
