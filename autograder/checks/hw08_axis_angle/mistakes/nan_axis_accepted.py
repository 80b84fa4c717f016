"""An axis that is not finite is accepted by both functions; it should be refused.

fails: matrix_refuses_what_is_no_axis, rotate_refuses_what_is_no_axis
names: ValueError for an axis with a NaN
"""


def _unit(axis):
    length = np.max(np.abs(axis))
    if length == 0:
        raise ValueError("no axis")
    return axis / length / np.linalg.norm(axis / length)
