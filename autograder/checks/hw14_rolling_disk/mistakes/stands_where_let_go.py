"""A disk let go at rest stays at rest.

fails: euler_simulation_follows_the_motion, matrix_simulation_follows_the_motion
also: a disk without tilt rate and roll rate is said to be at rest | What is at rest has no rates
names: Every row is the start
"""

_euler, _matrix = simulate_euler, simulate_matrix


def simulate_euler(t, state, **disk):
    return _euler(t, state, **disk) if np.any(state[5:]) else np.tile(state, (len(t), 1))


def simulate_matrix(t, state, **disk):
    return _matrix(t, state, **disk) if np.any(state[12:]) else np.tile(state, (len(t), 1))
