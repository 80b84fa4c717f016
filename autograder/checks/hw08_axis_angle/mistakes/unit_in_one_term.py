"""The axis is not a unit vector in the term with 1 - cos th.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""

def rotation_matrix(axis, angle):
    n, c, s = _unit(axis), np.cos(angle), np.sin(angle)
    return c * np.eye(3) + (1 - c) * np.outer(axis, axis) + s * skew(n)


def rotate(r, axis, angle):
    n, c, s = _unit(axis), np.cos(angle), np.sin(angle)
    return c * r + (1 - c) * np.dot(axis, r) * axis + s * np.cross(n, r)
