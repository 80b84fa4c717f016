"""The zero axis gives the identity; it should be refused.

fails: matrix_refuses_what_is_no_axis
names: does not raise ValueError for the zero axis
"""


def rotation_matrix(axis, angle):
    if not np.any(axis):
        return np.eye(3)
    n = _unit(axis)
    return np.cos(angle) * np.eye(3) + (1 - np.cos(angle)) * np.outer(n, n) + np.sin(angle) * skew(n)
