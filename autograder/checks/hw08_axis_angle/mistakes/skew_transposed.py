"""The transpose, r x v.

fails: skew_is_the_cross_product, matrix_turns_by_the_right_hand_rule
also: the transpose, the rotation the other way (look at the sign of the sin th term)
"""


def skew(v):
    x, y, z = v
    return np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]])
