"""1 + cos th for 1 - cos th.

fails: matrix_turns_by_the_right_hand_rule
"""


def rotation_matrix(axis, angle):
    n = _unit(axis)
    return np.cos(angle) * np.eye(3) + (1 + np.cos(angle)) * np.outer(n, n) + np.sin(angle) * skew(n)
