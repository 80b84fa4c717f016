"""The axle's name is not tested where the car is at rest.

fails: mechanics_refuses_other_axles
names: does not raise ValueError
"""

_friction, _simulate = friction_force, simulate


def friction_force(state, locked, **car):
    return np.zeros(2) if not np.any(state[3:]) else _friction(state, locked, **car)


def simulate(t, state, locked, **car):
    return np.tile(state, (len(t), 1)) if not np.any(state[3:]) else _simulate(t, state, locked, **car)
