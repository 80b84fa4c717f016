"""Times taken to be even.

fails: simulate_brakes
suspect: the times taken to be evenly spaced
"""

_right = simulate


def simulate(t, state, locked, **car):
    return _right(np.linspace(t[0], t[-1], len(t)), state, locked, **car)
