"""The times are treated as evenly spaced.

fails: simulate_brakes
also: the times are treated as evenly spaced, with the first step for all
"""

_right = simulate


def simulate(t, state, locked, **car):
    return _right(np.linspace(t[0], t[-1], len(t)), state, locked, **car)
