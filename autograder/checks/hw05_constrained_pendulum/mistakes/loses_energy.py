"""A projection that takes some energy away.

fails: energy_stays
numerics: the loss of a careless projection
names: the energy is off
"""

_right_simulate = simulate


def simulate(t, state, **parameters):
    states = _right_simulate(t, state, **parameters)
    states[:, 2:] *= np.exp(-1e-7 * (t - t[0]) * np.hypot(*states[:, 2:].T))[:, None]
    return states
