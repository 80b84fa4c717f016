"""rotate has r x n for n x r.

fails: vector_turns_by_the_right_hand_rule
suspect: the transpose
"""


def rotate(r, axis, angle):
    n = _unit(axis)
    a = angle
    return np.cos(a) * r + (1 - np.cos(a)) * np.dot(n, r) * n + -np.sin(a) * np.cross(n, r)
