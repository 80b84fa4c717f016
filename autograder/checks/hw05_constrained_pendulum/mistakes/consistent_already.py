"""A particle on the circle is given back as it is, whatever its velocity.

fails: consistent_state_is_the_nearest
names: on the circle already
"""

_right_consistent = consistent_state


def consistent_state(state, *, length):
    if math.isclose(math.hypot(*state[:2]), length):
        return state.copy()
    return _right_consistent(state, length=length)
