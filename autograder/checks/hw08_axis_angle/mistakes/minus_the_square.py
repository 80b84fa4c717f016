"""The formula has -(1 - cos th) [n x]^2 where (1 - cos th) [n x]^2 belongs.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""

def rotation_matrix(axis, angle):
    n, c, s = _unit(axis), np.cos(angle), np.sin(angle)
    return np.eye(3) - (1 - c) * skew(n) @ skew(n) + s * skew(n)


def rotate(r, axis, angle):
    n, c, s = _unit(axis), np.cos(angle), np.sin(angle)
    return r - (1 - c) * np.cross(n, np.cross(n, r)) + s * np.cross(n, r)
