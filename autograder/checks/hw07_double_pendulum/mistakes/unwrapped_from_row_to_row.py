"""Angles are unwrapped from row to row, which loses turns between two times.

fails: simulation_follows_the_equations
names: never wrap angles
"""

_right = simulate


def simulate(t, theta, omega, **known):
    states = _right(t, theta, omega, **known)
    wrapped = (states[:, :2] + math.pi) % (2 * math.pi) - math.pi
    wrapped[0] = theta
    return np.hstack([np.unwrap(wrapped, axis=0), states[:, 2:]])
