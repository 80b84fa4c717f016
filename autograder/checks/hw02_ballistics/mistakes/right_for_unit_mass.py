"""The drag force is taken for the acceleration.

fails: rates_are_newtons
suspect: not divided by the mass
"""


def state_derivative(t, state, *, mass, drag, gravity):
    _, _, vx, vy = state
    return np.array([vx, vy, -drag * vx, -drag * vy - gravity])
