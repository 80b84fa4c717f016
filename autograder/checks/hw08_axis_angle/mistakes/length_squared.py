"""The axis divided by the square of its length.

fails: matrix_turns_by_the_right_hand_rule, matrix_refuses_what_is_no_axis
"""


def rotation_matrix(axis, angle):
    n = axis / np.dot(axis, axis)
    return np.cos(angle) * np.eye(3) + _versine(angle) * np.outer(n, n) + np.sin(angle) * skew(n)
