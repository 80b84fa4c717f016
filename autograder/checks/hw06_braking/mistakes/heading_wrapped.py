"""The heading is wrapped to half a turn to either side; it should count whole turns.

fails: simulate_brakes
"""

_right = simulate


def simulate(t, state, locked, **car):
    states = _right(t, state, locked, **car)
    states[:, 2] = (states[:, 2] + math.pi) % (2 * math.pi) - math.pi
    return states
