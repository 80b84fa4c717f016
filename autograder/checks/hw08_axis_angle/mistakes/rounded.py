"""The result is rounded, to ten places and to three.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
names: the numbers are rounded
numerics: three or ten digits of sixteen
"""

_matrix, _vector = rotation_matrix, rotate


def rotation_matrix(axis, angle):
    return np.round(_matrix(axis, angle), 10)


def rotate(r, axis, angle):
    return np.round(_vector(r, axis, angle), 3)
