"""The part along the axis counts in full: its factor 1 - cos(angle) is missing.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""


def rotation_matrix(axis, angle):
    n = _unit(axis)
    return np.cos(angle) * np.eye(3) + np.outer(n, n) + np.sin(angle) * skew(n)


def rotate(r, axis, angle):
    n = _unit(axis)
    return np.cos(angle) * np.asarray(r) + (n @ r) * n + np.sin(angle) * np.cross(n, r)
