"""phi is wrapped to a turn from 0; it should count whole turns.

fails: simulate_rolls_and_rocks
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    states = _right(t, phi, phi_dot, **c)
    states[:, 0] %= 2 * math.pi
    return states
