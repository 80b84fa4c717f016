"""The origin is accepted; no point of the circle is nearest to it.

fails: consistent_state_refuses_the_origin
names: does not raise ValueError
"""

_right_state = consistent_state


def consistent_state(state, *, length):
    if not np.any(state[:2]):
        return np.array([0, -length, state[2], 0])
    return _right_state(state, length=length)
