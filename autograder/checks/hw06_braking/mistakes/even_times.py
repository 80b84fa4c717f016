"""The times taken to be evenly spaced.

fails: simulate_brakes
also: the times taken to be evenly spaced, the first step for all
"""

_right = simulate


def simulate(t, state, locked, **car):
    return _right(np.linspace(t[0], t[-1], len(t)), state, locked, **car)
