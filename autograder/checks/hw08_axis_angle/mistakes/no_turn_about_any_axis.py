"""For the angle 0 the axis is not looked at; a zero axis should still be refused.

fails: matrix_refuses_what_is_no_axis, rotate_refuses_what_is_no_axis
names: does not raise ValueError for the zero axis, no turn
"""

_matrix, _vector = rotation_matrix, rotate


def rotation_matrix(axis, angle):
    return np.eye(3) if angle == 0 else _matrix(axis, angle)


def rotate(r, axis, angle):
    return r if angle == 0 else _vector(r, axis, angle)
