"""A turn by 1e-12 taken for no turn.

fails: matrix_holds_for_every_angle
within: 1e-14
"""


def rotation_matrix(axis, angle):
    n = _unit(axis)
    a = 0.0 if abs(angle) < 1e-10 else angle
    return np.cos(a) * np.eye(3) + (1 - np.cos(a)) * np.outer(n, n) + np.sin(a) * skew(n)
