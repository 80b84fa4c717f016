"""K ** 2 squares each element of skew(n); K @ K is the product of the matrix with itself.

fails: matrix_turns_by_the_right_hand_rule
"""


def rotation_matrix(axis, angle):
    K = skew(_unit(axis))
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K**2
