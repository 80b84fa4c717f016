"""The angle is reduced modulo pi; a turn is 2 pi.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""

_matrix, _vector = rotation_matrix, rotate


def _mistaken(angle):
    return np.fmod(angle, np.pi)


def rotation_matrix(axis, angle):
    return _matrix(axis, _mistaken(angle))


def rotate(r, axis, angle):
    return _vector(r, axis, _mistaken(angle))
