"""A matrix that is off by 1e-7 is refused; it should be accepted.

fails: what_is_no_rotation_is_refused
names: axis_angle raised ValueError for a matrix with R^T R off by 7e-7
"""


def _rotation(R):
    if not (np.isfinite(R).all() and np.abs(R.T @ R - np.eye(3)).max() < 1e-12 and np.linalg.det(R) > 0):
        raise ValueError
    return R
