"""The vertical drag not divided by the mass.

fails: rates_are_newtons
also: the drag force not divided by the mass
"""


def state_derivative(t, state, *, mass, drag, gravity):
    _, _, vx, vy = state
    return np.array([vx, vy, -drag * vx, -drag * vy - gravity])
