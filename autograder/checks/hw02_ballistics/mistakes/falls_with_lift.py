"""The drag always points down: right on the way up only.

fails: rates_are_newtons
suspect: points down in the fall, too
"""


def state_derivative(t, state, *, mass, drag, gravity):
    _, _, vx, vy = state
    return np.array([vx, vy, -drag / mass * vx, -drag / mass * abs(vy) - gravity])
