"""The transpose.

fails: body_sequence_takes_the_axes_along
also: the transpose, the rotation the other way, in every turn
"""

_right_body = body_sequence


def body_sequence(steps):
    return _right_body(steps).T
