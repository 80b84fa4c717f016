"""The axis not made a unit vector in the (1 - cos th) term.

fails: matrix_turns_by_the_right_hand_rule
"""


def rotation_matrix(axis, angle):
    n = _unit(axis)
    return np.cos(angle) * np.eye(3) + _versine(angle) * np.outer(axis, axis) + np.sin(angle) * skew(n)
