"""-(1 - cos th) [n x]^2 for (1 - cos th) [n x]^2.

fails: matrix_turns_by_the_right_hand_rule
"""

def rotation_matrix(axis, angle):
    n = _unit(axis)
    K = skew(n)
    return np.eye(3) + np.sin(angle) * K - (1 - np.cos(angle)) * (K @ K)
