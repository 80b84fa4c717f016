"""rotate gives zero for r along the axis, where r x n is zero; r should stay as it is.

fails: vector_turns_by_the_right_hand_rule
"""

_right = rotate


def rotate(r, axis, angle):
    across = np.cross(_unit(axis), r)
    return _right(r, axis, angle) if np.linalg.norm(across) > 1e-9 * np.linalg.norm(r) else across
