"""Only the trace is tested for infinity.

fails: what_is_no_rotation_is_refused
names: ValueError for the identity, but for inf off the diagonal
"""


def _rotation(R):
    R = np.asarray(R, dtype=float)
    bad = np.isnan(R).any() or not np.isfinite(np.trace(R))
    if bad or np.abs(R.T @ R - np.eye(3)).max() > 1e-6 or np.linalg.det(R) < 0:
        raise ValueError
    return R
