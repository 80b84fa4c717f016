"""The formula has r where cos th r belongs, or n n^T where [n x]^2 belongs.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""

def rotation_matrix(axis, angle):
    n, c, s = _unit(axis), np.cos(angle), np.sin(angle)
    return np.eye(3) + (1 - c) * np.outer(n, n) + s * skew(n)


def rotate(r, axis, angle):
    n, c, s = _unit(axis), np.cos(angle), np.sin(angle)
    return r + (1 - c) * np.dot(n, r) * n + s * np.cross(n, r)
