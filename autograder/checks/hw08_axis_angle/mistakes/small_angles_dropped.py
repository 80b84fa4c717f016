"""A turn by 1e-12 is treated as no turn.

fails: matrix_holds_for_every_angle, vector_turns_by_every_angle
within: 1e-14
"""

_matrix, _vector = rotation_matrix, rotate


def _mistaken(angle):
    return 0.0 if abs(angle) < 1e-10 else angle


def rotation_matrix(axis, angle):
    return _matrix(axis, _mistaken(angle))


def rotate(r, axis, angle):
    return _vector(r, axis, _mistaken(angle))
