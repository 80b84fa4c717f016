"""1 - sin th where 1 - cos th belongs.

fails: vector_turns_by_the_right_hand_rule
suspect: 1 - sin th
"""

def rotate(r, axis, angle):
    r, n = np.asarray(r, float), _unit(axis)
    return np.cos(angle) * r + (1 - np.sin(angle)) * np.dot(n, r) * n + np.sin(angle) * np.cross(n, r)
