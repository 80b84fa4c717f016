"""The time of the stop counts from t[0], but is compared with the times in t.

fails: simulate_brakes
"""

_right = simulate


def simulate(t, state, locked, **car):
    late = t >= t[0] + abs(t[0])
    states = _right(t, state, locked, **car)
    states[late, 3:] = 0.0
    return states
