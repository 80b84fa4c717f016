"""The rates are zero below a tenth of a millimetre a second, as if the car were at rest.

fails: equations_in_any_motion
"""

_right = state_derivative


def state_derivative(t, state, locked, **car):
    sliding = math.hypot(state[3], _axles(locked, car["front"], car["rear"])[1] * state[4])
    return _right(t, state, locked, **car) * (sliding >= 1e-4)
