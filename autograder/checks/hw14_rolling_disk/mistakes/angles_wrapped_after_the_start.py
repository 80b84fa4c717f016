"""simulate_euler wraps yaw and roll, except in the first row.

fails: euler_simulation_follows_the_motion
names: never wrap angles
also: The angles are wrapped to a turn from 0
"""


_simulate = simulate_euler


def simulate_euler(t, state, **disk):
    states = _simulate(t, state, **disk)
    states[1:, [2, 4]] %= 2 * np.pi
    return states
