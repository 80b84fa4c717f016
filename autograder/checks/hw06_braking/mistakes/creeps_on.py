"""The car is at rest by its speed, but its place goes on.

fails: simulate_comes_to_rest_and_stays
"""

_right = simulate


def simulate(t, state, locked, **car):
    states = _right(t, state, locked, **car)
    still = ~states[:, 3:].any(axis=1)
    states[still, 0] += 1e-3 * state[3] * (t[still] - t[0])
    return states
