"""sin th is never negative: the root of 1 - cos^2 th has lost its sign.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""

def rotation_matrix(axis, angle):
    n, c, s = _unit(axis), np.cos(angle), np.sin(angle)
    return c * np.eye(3) + (1 - c) * np.outer(n, n) + np.sqrt(1 - c**2) * skew(n)


def rotate(r, axis, angle):
    n, c, s = _unit(axis), np.cos(angle), np.sin(angle)
    return c * r + (1 - c) * np.dot(n, r) * n + np.sqrt(1 - c**2) * np.cross(n, r)
