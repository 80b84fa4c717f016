"""n * n stands where np.outer(n, n) belongs; it has three squares, not all products n_x n_y.

fails: matrix_turns_by_the_right_hand_rule
"""


def rotation_matrix(axis, angle):
    n = _unit(axis)
    return np.cos(angle) * np.eye(3) + (1 - np.cos(angle)) * n * n + np.sin(angle) * skew(n)
