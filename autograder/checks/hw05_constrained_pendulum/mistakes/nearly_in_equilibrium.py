"""A particle at rest near the top or the bottom is left there; it should stay only exactly there.

fails: with_gravity_it_swings_or_goes_round
"""

_right_simulate = simulate


def simulate(t, state, *, length, **parameters):
    if not np.any(state[2:]) and abs(state[0]) < 1e-2 * length:
        return np.tile(state, (len(t), 1))
    return _right_simulate(t, state, length=length, **parameters)
