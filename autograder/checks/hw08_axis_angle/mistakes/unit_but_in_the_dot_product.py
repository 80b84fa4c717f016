"""The axis is not a unit vector in n . r.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""

def rotation_matrix(axis, angle):
    n, c, s = _unit(axis), np.cos(angle), np.sin(angle)
    return c * np.eye(3) + (1 - c) * np.outer(n, axis) + s * skew(n)


def rotate(r, axis, angle):
    n, c, s = _unit(axis), np.cos(angle), np.sin(angle)
    return c * r + (1 - c) * np.dot(axis, r) * n + s * np.cross(n, r)
