"""A particle at rest at the very top is nudged off it, however little; there it is in equilibrium.

fails: at_the_very_top_it_stays
names: is a term wrong
"""

_right_simulate = simulate


def simulate(t, state, *, length, **parameters):
    if state[0] == 0 and state[1] > 0 and not np.any(state[2:]):
        state = np.array([1e-12 * length, *state[1:]])
    return _right_simulate(t, state, length=length, **parameters)
