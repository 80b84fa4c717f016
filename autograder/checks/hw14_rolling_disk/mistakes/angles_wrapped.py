"""simulate_euler wraps the angles.

fails: euler_simulation_follows_the_motion
suspect: the angles wrapped
"""


_simulate = simulate_euler


def simulate_euler(t, state, **disk):
    states = _simulate(t, state, **disk)
    states[:, [2, 4]] = (states[:, [2, 4]] + np.pi) % (2 * np.pi) - np.pi
    return states
