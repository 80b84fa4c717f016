"""The rows are at evenly spaced times, with the first step for all.

fails: simulate_rolls_and_rocks
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    import numpy as np

    return _right(t[0] + (t[1] - t[0]) * np.arange(len(t)), phi, phi_dot, **c)
