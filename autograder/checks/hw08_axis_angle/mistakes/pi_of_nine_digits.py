"""The angle is reduced with a pi of nine digits.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
names: does a number have too few digits
numerics: nine digits of pi
"""

_matrix, _vector = rotation_matrix, rotate


def _mistaken(angle):
    return np.mod(angle, 2 * 3.14159265)


def rotation_matrix(axis, angle):
    return _matrix(axis, _mistaken(angle))


def rotate(r, axis, angle):
    return _vector(r, axis, _mistaken(angle))
