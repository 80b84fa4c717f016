"""A short axis is taken for none.

fails: matrix_depends_on_the_direction_alone
names: rotation_matrix raised ValueError for a very short axis
"""


def rotation_matrix(axis, angle):
    if np.linalg.norm(axis) < 1e-8:
        raise ValueError("no axis")
    n = _unit(axis)
    return np.cos(angle) * np.eye(3) + (1 - np.cos(angle)) * np.outer(n, n) + np.sin(angle) * skew(n)
