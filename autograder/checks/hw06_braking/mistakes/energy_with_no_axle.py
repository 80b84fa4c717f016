"""Without a name of the locked axle it is the rear one, for the kinetic energy.

fails: mechanics_refuses_other_axles
names: does not raise ValueError
"""

_right = kinetic_energy


def kinetic_energy(state, locked, **car):
    return _right(state, locked or "rear", **car) if locked is None else _right(state, locked, **car)
