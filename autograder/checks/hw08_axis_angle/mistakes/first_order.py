"""For a small angle the matrix has 1 where cos th belongs.

fails: matrix_holds_for_every_angle, vector_turns_by_every_angle
within: 1e-14
"""

_matrix, _vector = rotation_matrix, rotate


def rotation_matrix(axis, angle):
    return np.eye(3) + angle * skew(_unit(axis)) if abs(angle) < 1e-4 else _matrix(axis, angle)


def rotate(r, axis, angle):
    return r + angle * np.cross(_unit(axis), r) if abs(angle) < 1e-4 else _vector(r, axis, angle)
