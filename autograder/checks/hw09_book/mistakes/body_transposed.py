"""The result of body_sequence is the transpose of the right one.

fails: body_sequence_takes_the_axes_along
also: Every turn goes the other way
"""

_right_body = body_sequence


def body_sequence(steps):
    return _right_body(steps).T
