"""Only the largest component of the axis is tested, and minus infinity is not the largest.

fails: matrix_refuses_what_is_no_axis, rotate_refuses_what_is_no_axis
names: ValueError for an axis with minus infinity
"""


def _unit(axis):
    if np.isnan(axis).any() or np.max(axis) == np.inf or not np.any(axis):
        raise ValueError("no axis")
    finite = np.nan_to_num(axis) / np.max(np.abs(np.nan_to_num(axis)))
    return finite / np.linalg.norm(finite)
