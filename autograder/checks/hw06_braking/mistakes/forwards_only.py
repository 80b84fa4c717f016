"""The speed taken for positive.

fails: equations_in_any_motion
names: a car in reverse
"""

_right = state_derivative


def state_derivative(t, state, locked, **car):
    forwards = np.array([*state[:3], abs(state[3]), state[4]])
    return _right(t, forwards, locked, **car)
