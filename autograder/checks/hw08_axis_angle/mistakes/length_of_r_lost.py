"""rotate gives the direction of the turned vector.

fails: vector_turns_by_the_right_hand_rule
suspect: its length is lost
"""

_right = rotate


def rotate(r, axis, angle):
    return _right(r, axis, angle) / (np.linalg.norm(r) or 1.0)
