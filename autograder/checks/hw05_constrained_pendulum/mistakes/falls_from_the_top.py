"""The particle at rest at the very top falls; there it is in equilibrium.

fails: at_the_very_top_it_stays
"""

_right_simulate = simulate


def simulate(t, state, *, length, **parameters):
    if state[0] == 0 and not np.any(state[2:]):
        state = length * np.array([1e-6, math.copysign(1, state[1]), 0, 0])
    return _right_simulate(t, state, length=length, **parameters)
