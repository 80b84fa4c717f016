"""The angles are wrapped to half a turn to either side; they should count whole turns.

fails: euler_simulation_follows_the_motion
also: The angles are wrapped to a turn from 0
"""


_simulate = simulate_euler


def simulate_euler(t, state, **disk):
    states = _simulate(t, state, **disk)
    states[:, [2, 4]] = (states[:, [2, 4]] + np.pi) % (2 * np.pi) - np.pi
    return states
