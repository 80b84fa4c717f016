"""A particle at rest is taken to be in equilibrium wherever it is.

fails: with_gravity_it_swings_or_goes_round
names: let go at rest
"""

_right_simulate = simulate


def simulate(t, state, **parameters):
    if not np.any(state[2:]):
        return np.tile(state, (len(t), 1))
    return _right_simulate(t, state, **parameters)
