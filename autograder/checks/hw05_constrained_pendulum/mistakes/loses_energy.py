"""A little of the energy is lost at every step of a long run.

fails: energy_stays
numerics: the loss of a careless projection
names: Tighten rtol and atol
"""

_right_simulate = simulate


def simulate(t, state, **parameters):
    states = _right_simulate(t, state, **parameters)
    states[:, 2:] *= np.exp(-4e-6 * np.clip(t - t[0] - 50.0, 0.0, None))[:, None]
    return states
