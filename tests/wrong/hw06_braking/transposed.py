"""A row for each number of the state.

fails: simulate_brakes
"""

_right = simulate


def simulate(t, state, locked, **car):
    return _right(t, state, locked, **car).T
