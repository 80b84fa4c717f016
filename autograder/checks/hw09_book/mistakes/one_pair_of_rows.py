"""Of the rows only the first two are tested for a right angle.

fails: what_is_no_rotation_is_refused
names: ValueError for a shear of 1e-5 after a rotation
"""


def _rotation(R):
    R = np.asarray(R, dtype=float)
    off = [R[0] @ R[1], *((R * R).sum(axis=1) - 1)]
    if not np.isfinite(R).all() or np.abs(off).max() > 1e-6 or np.linalg.det(R) < 0:
        raise ValueError
    return R
