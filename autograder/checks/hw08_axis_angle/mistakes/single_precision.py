"""The result is in single precision.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
names: in single precision
numerics: seven digits of sixteen
"""

_matrix, _vector = rotation_matrix, rotate


def rotation_matrix(axis, angle):
    return _matrix(axis, angle).astype(np.float32)


def rotate(r, axis, angle):
    return _vector(r, axis, angle).astype(np.float32)
