"""The velocity keeps its angular momentum about the hinge, but should keep its tangential part.

fails: consistent_state_is_the_nearest
"""

_right = consistent_state


def consistent_state(state, *, length):
    found = _right(state, length=length)
    found[2:] *= math.hypot(*state[:2]) / length
    return found
