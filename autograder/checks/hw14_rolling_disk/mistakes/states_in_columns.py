"""simulate_matrix returns the states as columns.

fails: matrix_simulation_follows_the_motion
names: (15, 60), not an array of shape (60, 15)
"""


_simulate = simulate_matrix


def simulate_matrix(t, state, **disk):
    return _simulate(t, state, **disk).T
