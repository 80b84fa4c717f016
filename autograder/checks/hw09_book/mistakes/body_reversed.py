"""body_sequence multiplies on the left: axes fixed in space.

fails: body_sequence_takes_the_axes_along
suspect: the order reversed
"""


def body_sequence(steps):
    return space_sequence(steps)
