"""A short axis is given no turn; only its direction should count.

fails: matrix_depends_on_the_direction_alone, vector_turns_by_every_angle
"""

_matrix, _vector = rotation_matrix, rotate


def rotation_matrix(axis, angle):
    return np.eye(3) if 0 < np.linalg.norm(axis) < 1e-8 else _matrix(axis, angle)


def rotate(r, axis, angle):
    return r if 0 < np.linalg.norm(axis) < 1e-8 else _vector(r, axis, angle)
