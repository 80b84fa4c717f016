"""The start is used at t = 0; it is the state at t[0].

fails: simulate_rolls_and_rocks
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    import numpy as np

    first = min(0.0, t[0] - 1.0)
    backwards = _right(np.array([0.0, abs(t[0])]), phi, phi_dot if t[0] > 0 else -phi_dot, **c)[1]
    start = backwards if t[0] > 0 else (backwards[0], -backwards[1])
    return _right(t, *start, **c)
