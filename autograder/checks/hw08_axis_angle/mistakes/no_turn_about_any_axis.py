"""The angle 0 gives the identity before the axis is looked at.

fails: matrix_refuses_what_is_no_axis
names: does not raise ValueError for the zero axis, no turn
"""

_right_rotation_matrix = rotation_matrix


def rotation_matrix(axis, angle):
    return np.eye(3) if angle == 0 else _right_rotation_matrix(axis, angle)
