"""The rows are at evenly spaced times, not at the times in t.

fails: simulate_rolls_and_rocks
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    import numpy as np

    return _right(np.linspace(t[0], t[-1], len(t)), phi, phi_dot, **c)
