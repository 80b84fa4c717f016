"""The axis is divided by n . n, its length squared.

fails: matrix_turns_by_the_right_hand_rule, matrix_refuses_what_is_no_axis
suspect: the axis divided by the square of its length
"""


def rotation_matrix(axis, angle):
    n = axis / np.dot(axis, axis)
    return np.cos(angle) * np.eye(3) + _versine(angle) * np.outer(n, n) + np.sin(angle) * skew(n)
