"""The times taken to be evenly spaced.

fails: simulate_rolls_and_rocks
also: the times taken to be evenly spaced, the first step for all
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    import numpy as np

    return _right(np.linspace(t[0], t[-1], len(t)), phi, phi_dot, **c)
