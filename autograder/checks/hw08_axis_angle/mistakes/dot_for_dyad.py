"""The identity times n . n stands where the dyad n n^T belongs.

fails: matrix_turns_by_the_right_hand_rule
"""


def rotation_matrix(axis, angle):
    n = _unit(axis)
    return np.eye(3) + np.sin(angle) * skew(n)
