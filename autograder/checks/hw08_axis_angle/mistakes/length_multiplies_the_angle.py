"""The length of the axis multiplies the angle.

fails: matrix_turns_by_the_right_hand_rule
"""


def rotation_matrix(axis, angle):
    n, turn = _unit(axis), angle * np.linalg.norm(axis)
    return np.eye(3) + np.sin(turn) * skew(n) + (1 - np.cos(turn)) * skew(n) @ skew(n)
