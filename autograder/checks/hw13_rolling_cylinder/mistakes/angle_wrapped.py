"""Phi wrapped to half a turn to either side.

fails: simulate_rolls_and_rocks
also: phi wrapped to a turn from 0
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    states = _right(t, phi, phi_dot, **c)
    states[:, 0] = (states[:, 0] + math.pi) % (2 * math.pi) - math.pi
    return states
