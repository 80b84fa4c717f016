"""simulate_euler wraps yaw and roll to a turn from 0.

fails: euler_simulation_follows_the_motion
suspect: the angles wrapped to a turn from 0
"""


_simulate = simulate_euler


def simulate_euler(t, state, **disk):
    states = _simulate(t, state, **disk)
    states[:, [2, 4]] %= 2 * np.pi
    return states
