"""A mass that starts at rest is left where it is.

fails: simulate_does_not_depend_on_the_sampling
names: every row is the start
"""

_right_simulate = simulate


def simulate(t, position, velocity, *, mass, stiffness, gravity):
    if not np.any(velocity):
        return np.tile([*position, 0.0, 0.0, 0.0], (len(t), 1))
    return _right_simulate(t, position, velocity, mass=mass, stiffness=stiffness, gravity=gravity)
