"""r is made a unit vector: its length is lost.

fails: vector_turns_by_the_right_hand_rule
"""

_right = rotate


def rotate(r, axis, angle):
    return _right(r, axis, angle) / (np.linalg.norm(r) or 1.0)
