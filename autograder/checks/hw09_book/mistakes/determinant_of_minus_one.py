"""Only a determinant of exactly -1 is refused; reflections that are nearly orthogonal are accepted.

fails: what_is_no_rotation_is_refused
names: does not raise ValueError for a reflection times 1 + 4e-7
"""


def _rotation(R):
    if not np.abs(R.T @ R - np.eye(3)).max() <= 1e-6 or abs(np.linalg.det(R) + 1) < 1e-12:
        raise ValueError
    return R
