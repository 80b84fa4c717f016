"""The angular momentum about the hinge is kept.

fails: consistent_state_is_the_nearest
suspect: the angular momentum about the hinge kept
"""

_right = consistent_state


def consistent_state(state, *, length):
    found = _right(state, length=length)
    found[2:] *= math.hypot(*state[:2]) / length
    return found
