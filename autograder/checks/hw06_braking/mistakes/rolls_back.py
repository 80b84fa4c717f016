"""After the stop friction goes on pushing as before, and the car goes back.

fails: simulate_comes_to_rest_and_stays
"""

_right = simulate


def simulate(t, state, locked, **car):
    states = _right(t, state, locked, **car)
    still = ~states[:, 3:].any(axis=1) & (np.arange(len(t)) > 0)
    if still.any():
        push = np.sign(state[3]) * car["friction"] * car["gravity"]
        states[still, 3] = -push * (t[still] - t[still][0] + 0.1)  # it stopped before the first of these
    return states
