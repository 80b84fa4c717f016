"""The angle reduced modulo 360, which is no whole number of turns in radians, in every turn.

fails: space_sequence_takes_the_first_step_first, body_sequence_takes_the_axes_along
"""

_space, _body = space_sequence, body_sequence


def space_sequence(steps):
    return _space([(axis, angle % 360) for axis, angle in steps])


def body_sequence(steps):
    return _body([(axis, angle % 360) for axis, angle in steps])
