"""The cosine of the first term is forgotten.

fails: vector_turns_by_the_right_hand_rule
suspect: r for cos th r
"""

def rotate(r, axis, angle):
    r, n = np.asarray(r, float), _unit(axis)
    return r + (1 - np.cos(angle)) * np.dot(n, r) * n + np.sin(angle) * np.cross(n, r)
