"""The order is reversed: these axes are fixed in space.

fails: body_sequence_takes_the_axes_along
"""


def body_sequence(steps):
    return space_sequence(steps)
