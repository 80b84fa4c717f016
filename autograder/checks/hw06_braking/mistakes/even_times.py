"""The times are treated as evenly spaced.

fails: simulate_brakes
"""

_right = simulate


def simulate(t, state, locked, **car):
    return _right(np.linspace(t[0], t[-1], len(t)), state, locked, **car)
