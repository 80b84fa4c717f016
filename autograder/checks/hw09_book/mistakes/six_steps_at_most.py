"""Sequences end with the sixth step, however many there are.

fails: space_sequence_takes_the_first_step_first, body_sequence_takes_the_axes_along
"""

_space, _body = space_sequence, body_sequence


def space_sequence(steps):
    return _space(steps[:6])


def body_sequence(steps):
    return _body(steps[:6])
