"""The radial part of the velocity has l^2 where the square of the distance from the hinge belongs.

fails: consistent_state_is_the_nearest
"""

_right_state = consistent_state


def consistent_state(state, *, length):
    r, v = state[:2], state[2:]
    return np.append(_right_state(state, length=length)[:2], v - (r @ v) / length**2 * r)
