"""skew divides by the length of v, and gives the identity for the zero vector.

fails: skew_is_the_cross_product
"""

_right = skew


def skew(v):
    return _right(v) if np.any(v) else np.eye(3)
