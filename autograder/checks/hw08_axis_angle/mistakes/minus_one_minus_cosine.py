"""-(1 - cos th) for 1 - cos th.

fails: vector_turns_by_the_right_hand_rule
"""

def rotate(r, axis, angle):
    r, n = np.asarray(r, float), _unit(axis)
    return np.cos(angle) * r - (1 - np.cos(angle)) * np.dot(n, r) * n + np.sin(angle) * np.cross(n, r)
