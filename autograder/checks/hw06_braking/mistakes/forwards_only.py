"""The speed is treated as positive; the car may go in reverse.

fails: equations_in_any_motion
"""

_right = state_derivative


def state_derivative(t, state, locked, **car):
    forwards = np.array([*state[:3], abs(state[3]), state[4]])
    return _right(t, forwards, locked, **car)
