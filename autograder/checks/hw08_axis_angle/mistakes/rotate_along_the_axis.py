"""rotate needs r across the axis: along it, r x n has no direction.

fails: vector_turns_by_the_right_hand_rule
"""

_right = rotate


def rotate(r, axis, angle):
    across = np.cross(_unit(axis), r)
    return _right(r, axis, angle) if np.linalg.norm(across) > 1e-9 * np.linalg.norm(r) else across
