"""A matrix with NaN goes through, as every comparison with NaN is false.

fails: what_is_no_rotation_is_refused
names: ValueError for a matrix with a NaN
"""


def _rotation(R):
    if np.abs(R.T @ R - np.eye(3)).max() > 1e-6 or np.linalg.det(R) < 0:
        raise ValueError
    return R
