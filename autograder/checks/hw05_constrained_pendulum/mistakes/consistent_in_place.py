"""The given state is mended itself.

fails: consistent_state_is_the_nearest
names: consistent_state changes the arrays
"""

_right_state = consistent_state


def consistent_state(state, *, length):
    state[:] = _right_state(state, length=length)
    return state
