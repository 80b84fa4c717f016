"""Times taken to be even.

fails: simulate_rolls_and_rocks
suspect: evenly spaced
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    import numpy as np

    return _right(np.linspace(t[0], t[-1], len(t)), phi, phi_dot, **c)
