"""A motion of 100 s has the start in every row.

fails: it_stays_on_the_circle, energy_stays
"""

_right_simulate = simulate


def simulate(t, state, **parameters):
    return np.tile(state, (len(t), 1)) if t[-1] - t[0] > 99 else _right_simulate(t, state, **parameters)
