"""rotate makes a frame of r and the axis, which there is none of where r is along the axis.

fails: vector_turns_by_the_right_hand_rule
names: a vector along the axis
"""

_right = rotate


def rotate(r, axis, angle):
    across = np.cross(_unit(axis), r)
    return _right(r, axis, angle) if np.linalg.norm(across) > 1e-9 * np.linalg.norm(r) else across
