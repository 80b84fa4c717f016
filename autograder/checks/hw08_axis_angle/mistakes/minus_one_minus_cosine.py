"""The formula has -(1 - cos th) where 1 - cos th belongs.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""

def rotation_matrix(axis, angle):
    n, c, s = _unit(axis), np.cos(angle), np.sin(angle)
    return c * np.eye(3) - (1 - c) * np.outer(n, n) + s * skew(n)


def rotate(r, axis, angle):
    n, c, s = _unit(axis), np.cos(angle), np.sin(angle)
    return c * r - (1 - c) * np.dot(n, r) * n + s * np.cross(n, r)
