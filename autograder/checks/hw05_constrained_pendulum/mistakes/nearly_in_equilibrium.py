"""At rest within a hundredth of the length of the line through the hinge it is taken to be in equilibrium.

fails: with_gravity_it_swings_or_goes_round
names: exactly at the top
"""

_right_simulate = simulate


def simulate(t, state, *, length, **parameters):
    if not np.any(state[2:]) and abs(state[0]) < 1e-2 * length:
        return np.tile(state, (len(t), 1))
    return _right_simulate(t, state, length=length, **parameters)
