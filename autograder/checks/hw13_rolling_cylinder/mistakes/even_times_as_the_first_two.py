"""The times taken as even, all as far apart as the first two.

fails: simulate_rolls_and_rocks
suspect: evenly spaced
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    import numpy as np

    return _right(t[0] + (t[1] - t[0]) * np.arange(len(t)), phi, phi_dot, **c)
