"""n * r stands where the number n . r belongs; it multiplies element by element.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""

def rotation_matrix(axis, angle):
    n, c, s = _unit(axis), np.cos(angle), np.sin(angle)
    return c * np.eye(3) + (1 - c) * np.diag(n**2) + s * skew(n)


def rotate(r, axis, angle):
    n, c, s = _unit(axis), np.cos(angle), np.sin(angle)
    return c * r + (1 - c) * (n * r) * n + s * np.cross(n, r)
