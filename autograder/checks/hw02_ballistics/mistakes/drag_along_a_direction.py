"""The drag is along the direction of the velocity, which a particle at rest does not have.

fails: rates_are_newtons
names: NaN or infinity for a particle at rest
"""


def state_derivative(t, state, *, mass, drag, gravity):
    velocity = np.asarray(state[2:])
    speed = np.linalg.norm(velocity)
    with np.errstate(all="ignore"):
        direction = velocity / speed
    return np.hstack([velocity, -drag * speed / mass * direction - [0.0, gravity]])
