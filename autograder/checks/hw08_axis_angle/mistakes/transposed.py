"""The transpose, the rotation the other way (look at the sign of the sin th term).

fails: matrix_turns_by_the_right_hand_rule
"""


def rotation_matrix(axis, angle):
    n = _unit(axis)
    a = angle
    return np.cos(a) * np.eye(3) + (1 - np.cos(a)) * np.outer(n, n) + -np.sin(a) * skew(n)
