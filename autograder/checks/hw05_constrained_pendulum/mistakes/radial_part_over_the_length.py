"""The radial part of the velocity with l^2 for x^2 + y^2, off the circle.

fails: consistent_state_is_the_nearest
suspect: over l^2
"""

_right_state = consistent_state


def consistent_state(state, *, length):
    r, v = state[:2], state[2:]
    return np.append(_right_state(state, length=length)[:2], v - (r @ v) / length**2 * r)
