"""You measure the time of the stop from t[0] but compare it with t; add t[0].

fails: simulate_brakes
"""

_right = simulate


def simulate(t, state, locked, **car):
    late = t >= t[0] + abs(t[0])
    states = _right(t, state, locked, **car)
    states[late, 3:] = 0.0
    return states
