"""The drag force is not divided by the mass.

fails: rates_are_newtons
"""


def state_derivative(t, state, *, mass, drag, gravity):
    _, _, vx, vy = state
    return np.array([vx, vy, -drag * vx, -drag * vy - gravity])
