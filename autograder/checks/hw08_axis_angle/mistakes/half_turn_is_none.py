"""The matrix of a half turn is made with the sine alone, which is zero there.

fails: matrix_turns_by_the_right_hand_rule
names: for a half turn about a coordinate axis; it is taken for no turn
"""

_right = rotation_matrix


def rotation_matrix(axis, angle):
    if abs(np.sin(angle)) < 1e-15:
        return np.eye(3) + 0.0 * _right(axis, angle)
    return _right(axis, angle)
