"""Sin th never negative (a root of 1 - cos^2 th has lost the sign).

fails: matrix_turns_by_the_right_hand_rule
"""


def rotation_matrix(axis, angle):
    n, c = _unit(axis), np.cos(angle)
    return c * np.eye(3) + (1 - c) * np.outer(n, n) + np.sqrt(1 - c**2) * skew(n)
