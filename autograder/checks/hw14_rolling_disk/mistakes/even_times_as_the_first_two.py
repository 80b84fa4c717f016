"""The times are treated as evenly spaced.

fails: euler_simulation_follows_the_motion, matrix_simulation_follows_the_motion
"""


_euler, _matrix = simulate_euler, simulate_matrix


def _even(t):
    return t[0] + (t[1] - t[0]) * np.arange(len(t))


def simulate_euler(t, state, **disk):
    return _euler(_even(t), state, **disk)


def simulate_matrix(t, state, **disk):
    return _matrix(_even(t), state, **disk)
