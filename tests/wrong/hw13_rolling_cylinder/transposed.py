"""One row for phi, one for phi_dot.

fails: simulate_rolls_and_rocks
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    return _right(t, phi, phi_dot, **c).T
