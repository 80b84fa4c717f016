"""A disk that starts at rest is left where it is.

fails: euler_simulation_follows_the_motion, matrix_simulation_follows_the_motion
also: A disk without tilt rate and roll rate is treated as at rest | A disk at rest is given no rates and no energy, and only its weight as contact force
names: Every row is the start
"""

_euler, _matrix = simulate_euler, simulate_matrix


def simulate_euler(t, state, **disk):
    return _euler(t, state, **disk) if np.any(state[5:]) else np.tile(state, (len(t), 1))


def simulate_matrix(t, state, **disk):
    return _matrix(t, state, **disk) if np.any(state[12:]) else np.tile(state, (len(t), 1))
