"""body_sequence gives the matrix from space to body components.

fails: body_sequence_takes_the_axes_along
suspect: the transpose
"""

_right_body = body_sequence


def body_sequence(steps):
    return _right_body(steps).T
