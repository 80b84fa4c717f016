"""n * n has three squares; the matrix of all products n_x n_y is np.outer(n, n).

fails: matrix_turns_by_the_right_hand_rule
"""


def rotation_matrix(axis, angle):
    n = _unit(axis)
    return np.cos(angle) * np.eye(3) + (1 - np.cos(angle)) * n * n + np.sin(angle) * skew(n)
