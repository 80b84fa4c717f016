"""The vertical drag is not divided by the mass.

fails: rates_are_newtons
"""


def state_derivative(t, state, *, mass, drag, gravity):
    _, _, vx, vy = state
    return np.array([vx, vy, -drag / mass * vx, -drag * vy - gravity])
