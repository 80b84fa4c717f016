"""Positions close to the origin are refused; only the origin itself has no nearest point.

fails: consistent_state_is_the_nearest
"""

_right_state = consistent_state


def consistent_state(state, *, length):
    if np.allclose(state[:2], 0):
        raise ValueError("no direction")
    return _right_state(state, length=length)
