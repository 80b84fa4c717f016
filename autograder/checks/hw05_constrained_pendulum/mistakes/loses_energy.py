"""A little of the energy is lost at every step.

fails: energy_stays
numerics: the loss of a careless projection
names: Tighten rtol and atol
"""

_right_simulate = simulate


def simulate(t, state, **parameters):
    states = _right_simulate(t, state, **parameters)
    states[:, 2:] *= np.exp(-1e-7 * (t - t[0]) * np.hypot(*states[:, 2:].T))[:, None]
    return states
