"""The vertical drag points down in the fall, too; there it should point up.

fails: rates_are_newtons
"""


def state_derivative(t, state, *, mass, drag, gravity):
    _, _, vx, vy = state
    return np.array([vx, vy, -drag / mass * vx, -drag / mass * abs(vy) - gravity])
