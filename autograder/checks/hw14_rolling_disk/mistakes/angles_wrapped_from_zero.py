"""The angles are wrapped to a turn from 0.

fails: euler_simulation_follows_the_motion
"""


_simulate = simulate_euler


def simulate_euler(t, state, **disk):
    states = _simulate(t, state, **disk)
    states[:, [2, 4]] %= 2 * np.pi
    return states
