"""The place moves with the sideways velocity of the locked axle; G has another.

fails: equations_of_motion
"""

_right = state_derivative


def state_derivative(t, state, locked, *, front, rear, **car):
    rates = _right(t, state, locked, front=front, rear=rear, **car)
    sideways = _axles(locked, front, rear)[1] * state[4]
    s, c = math.sin(state[2]), math.cos(state[2])
    rates[:2] = state[3] * c - sideways * s, state[3] * s + sideways * c
    return rates
