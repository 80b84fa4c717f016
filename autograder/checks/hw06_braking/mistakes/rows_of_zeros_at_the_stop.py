"""After the stop all of the row is zero, the place and heading as well.

fails: simulate_comes_to_rest_and_stays
"""

_right = simulate


def simulate(t, state, locked, **car):
    states = _right(t, state, locked, **car)
    stopped = ~states[:, 3:].any(axis=1) & (np.arange(len(t)) > 0)
    states[stopped & state[3:].any()] = 0.0
    return states
