"""The matrix turns the other way.

fails: matrix_turns_by_the_right_hand_rule
suspect: the transpose
"""


def rotation_matrix(axis, angle):
    n = _unit(axis)
    return np.cos(angle) * np.eye(3) + (1 - np.cos(angle)) * np.outer(n, n) - np.sin(angle) * skew(n)
