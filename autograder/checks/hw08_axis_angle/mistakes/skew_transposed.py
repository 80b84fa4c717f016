"""skew is r x v; the matrix is built with it.

fails: skew_is_the_cross_product, matrix_turns_by_the_right_hand_rule
suspect: the transpose
"""


def skew(v):
    x, y, z = v
    return np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]])
