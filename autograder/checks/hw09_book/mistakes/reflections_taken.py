"""The determinant is not tested, so reflections are accepted.

fails: what_is_no_rotation_is_refused
names: does not raise ValueError for a reflection
"""


def _rotation(R):
    if not np.abs(R.T @ R - np.eye(3)).max() <= 1e-6:
        raise ValueError
    return R
