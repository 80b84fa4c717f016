"""After the stop it goes back as it came.

fails: simulate_comes_to_rest_and_stays
names: it goes back after the stop
"""

_right = simulate


def simulate(t, state, locked, **car):
    states = _right(t, state, locked, **car)
    still = ~states[:, 3:].any(axis=1) & (np.arange(len(t)) > 0)
    states[still, 3] = -1e-2 * state[3] * (t[still] - t[0])
    return states
