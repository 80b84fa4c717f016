"""The end of the integration, a time since t[0], compared with the times of the clock.

fails: simulate_brakes
"""

_right = simulate


def simulate(t, state, locked, **car):
    late = t >= t[0] + abs(t[0])
    states = _right(t, state, locked, **car)
    states[late, 3:] = 0.0
    return states
