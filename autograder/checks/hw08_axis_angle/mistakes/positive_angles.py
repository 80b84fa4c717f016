"""The matrix is right for positive angles only.

fails: matrix_turns_by_the_right_hand_rule
suspect: the sign of the angle dropped
"""


def rotation_matrix(axis, angle):
    n = _unit(axis)
    a = abs(angle)
    return np.cos(a) * np.eye(3) + (1 - np.cos(a)) * np.outer(n, n) + np.sin(a) * skew(n)
