"""A particle that starts at rest is left where it is; it should stay only in equilibrium.

fails: with_gravity_it_swings_or_goes_round
"""

_right_simulate = simulate


def simulate(t, state, **parameters):
    if not np.any(state[2:]):
        return np.tile(state, (len(t), 1))
    return _right_simulate(t, state, **parameters)
