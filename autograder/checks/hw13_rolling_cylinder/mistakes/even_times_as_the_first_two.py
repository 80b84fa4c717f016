"""The times taken to be evenly spaced.

fails: simulate_rolls_and_rocks
also: the times taken to be evenly spaced, the first step for all
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    import numpy as np

    return _right(t[0] + (t[1] - t[0]) * np.arange(len(t)), phi, phi_dot, **c)
