"""The given array is changed: work on a copy.

fails: consistent_state_is_the_nearest
names: consistent_state changes the arrays
"""

_right_state = consistent_state


def consistent_state(state, *, length):
    state[:] = _right_state(state, length=length)
    return state
