"""A car at rest from the start is divided by its speed.

fails: simulate_comes_to_rest_and_stays
names: simulate returned NaN or infinity
"""

_right = simulate


def simulate(t, state, locked, **car):
    return _right(t, state, locked, **car) / (1.0 if any(state[3:]) else math.nan)
