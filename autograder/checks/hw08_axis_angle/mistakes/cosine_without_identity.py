"""cos(angle) is added to all nine elements: as a matrix it is cos(angle) times the identity.

fails: matrix_turns_by_the_right_hand_rule
"""


def rotation_matrix(axis, angle):
    n = _unit(axis)
    return np.cos(angle) + (1 - np.cos(angle)) * np.outer(n, n) + np.sin(angle) * skew(n)
