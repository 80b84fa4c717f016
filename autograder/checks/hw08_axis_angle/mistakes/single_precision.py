"""The matrix in single precision.

fails: matrix_turns_by_the_right_hand_rule
names: nearly right: its numbers are in single precision
numerics: seven digits of sixteen
"""

_right_rotation_matrix = rotation_matrix


def rotation_matrix(axis, angle):
    return _right_rotation_matrix(axis, angle).astype(np.float32)
