"""phi is wrapped to half a turn on either side; it should count whole turns.

fails: simulate_rolls_and_rocks
"""

_right = simulate


def simulate(t, phi, phi_dot, **c):
    states = _right(t, phi, phi_dot, **c)
    states[:, 0] = (states[:, 0] + math.pi) % (2 * math.pi) - math.pi
    return states
