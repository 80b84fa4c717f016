"""G moves only along the car: its velocity to the side is left out.

fails: equations_of_motion
"""

_right = state_derivative


def state_derivative(t, state, locked, **car):
    rates = _right(t, state, locked, **car)
    rates[:2] = state[3] * math.cos(state[2]), state[3] * math.sin(state[2])
    return rates
