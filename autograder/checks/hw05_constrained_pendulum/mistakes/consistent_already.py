"""A particle that is on the circle keeps the radial part of its velocity.

fails: consistent_state_is_the_nearest
"""

_right_consistent = consistent_state


def consistent_state(state, *, length):
    if math.isclose(math.hypot(*state[:2]), length):
        return state.copy()
    return _right_consistent(state, length=length)
