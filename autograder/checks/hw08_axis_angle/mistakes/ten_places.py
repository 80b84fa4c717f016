"""The matrix rounded to ten places.

fails: matrix_turns_by_the_right_hand_rule
names: nearly right: its numbers are rounded
numerics: ten digits of sixteen
"""

_right_rotation_matrix = rotation_matrix


def rotation_matrix(axis, angle):
    return np.round(_right_rotation_matrix(axis, angle), 10)
