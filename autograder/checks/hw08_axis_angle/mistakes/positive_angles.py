"""The angle has lost its sign.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""

_matrix, _vector = rotation_matrix, rotate


def _mistaken(angle):
    return abs(angle)


def rotation_matrix(axis, angle):
    return _matrix(axis, _mistaken(angle))


def rotate(r, axis, angle):
    return _vector(r, axis, _mistaken(angle))
