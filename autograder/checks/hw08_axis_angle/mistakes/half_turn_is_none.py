"""A half turn is treated as no turn: its sine is zero, but its cosine is -1.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""

_matrix, _vector = rotation_matrix, rotate


def _mistaken(angle):
    return 0.0 if abs(np.sin(angle)) < 1e-15 else angle


def rotation_matrix(axis, angle):
    return _matrix(axis, _mistaken(angle))


def rotate(r, axis, angle):
    return _vector(r, axis, _mistaken(angle))
