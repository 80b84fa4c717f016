"""The rates have a tenth more friction than friction_force gives.

fails: equations_of_motion
"""

_right = state_derivative


def state_derivative(t, state, locked, **car):
    rates = _right(t, state, locked, **car)
    return rates + 0.1 * (rates - _right(t, state, locked, **{**car, "friction": 0.0}))
