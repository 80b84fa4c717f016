"""The part along the axis is added as the number n . r; it should be (n . r) n.

fails: vector_turns_by_the_right_hand_rule
"""


def rotate(r, axis, angle):
    n = _unit(axis)
    return np.cos(angle) * r + (1 - np.cos(angle)) * np.dot(n, r) + np.sin(angle) * np.cross(n, r)
