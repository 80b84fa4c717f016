"""skew(v) r is r x v; it must be v x r.

fails: skew_is_the_cross_product, matrix_turns_by_the_right_hand_rule
also: The rotation goes the other way
"""

def skew(v):
    x, y, z = v
    return np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]])
