"""The angle is in single precision where it is large.

fails: matrix_holds_for_every_angle, vector_turns_by_every_angle
"""

_matrix, _vector = rotation_matrix, rotate


def _mistaken(angle):
    return np.float32(angle).item() if abs(angle) > 50 else angle


def rotation_matrix(axis, angle):
    return _matrix(axis, _mistaken(angle))


def rotate(r, axis, angle):
    return _vector(r, axis, _mistaken(angle))
