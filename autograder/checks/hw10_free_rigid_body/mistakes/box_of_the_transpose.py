"""The box is turned by the transpose.

fails: the_box_has_its_twelve_edges
names: belong to the transpose
"""

_right_wireframe = wireframe


def wireframe(R, *, size):
    return _right_wireframe(R.T, size=size)
