"""Whether the first column and the last are perpendicular is not tested.

fails: what_is_no_rotation_is_refused
names: ValueError for a rotation with a shear of 1e-5
"""


def _rotation(R):
    a, b, c = np.transpose(R)
    off = [a @ b, b @ c, a @ a - 1, b @ b - 1, c @ c - 1]
    if not np.isfinite(R).all() or np.abs(off).max() > 1e-6 or np.linalg.det(R) < 0:
        raise ValueError
    return np.asarray(R)
