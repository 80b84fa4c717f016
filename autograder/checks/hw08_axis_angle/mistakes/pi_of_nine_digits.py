"""The angle is reduced with a pi of nine digits.

fails: matrix_turns_by_the_right_hand_rule
names: nearly right: some number in it has too few digits
numerics: nine digits of pi
"""

_right_rotation_matrix = rotation_matrix


def rotation_matrix(axis, angle):
    return _right_rotation_matrix(axis, np.mod(angle, 2 * 3.14159265))
