"""The rows and columns are exchanged: solve_ivp returns (2, n).

fails: simulate_rolls_and_rocks
names: (2, 200), not an array of shape (200, 2)
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    return _right(t, phi, phi_dot, **c).T
