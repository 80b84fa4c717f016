"""np.allclose compares R^T R with I: its rtol allows 1e-5 beside a one.

fails: what_is_no_rotation_is_refused
names: Do you use np.allclose?
"""


def _rotation(R):
    R = np.asarray(R, dtype=float)
    if not (np.isfinite(R).all() and np.allclose(R @ R.T, np.eye(3), atol=1e-6) and np.linalg.det(R) > 0):
        raise ValueError
    return R
