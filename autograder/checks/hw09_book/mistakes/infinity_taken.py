"""Only NaN is looked for: an infinite element makes NaN of R^T R, and a comparison with it is false.

fails: what_is_no_rotation_is_refused
names: ValueError for the identity, but for inf on the diagonal
"""


def _rotation(R):
    R = np.asarray(R, dtype=float)
    if np.isnan(R).any() or np.abs(R.T @ R - np.eye(3)).max() > 1e-6 or np.linalg.det(R) < 0:
        raise ValueError
    return R
