"""r for cos th r, or n n^T for [n x]^2 in a formula with it.

fails: vector_turns_by_the_right_hand_rule
"""

def rotate(r, axis, angle):
    r, n = np.asarray(r, float), _unit(axis)
    return r + (1 - np.cos(angle)) * np.dot(n, r) * n + np.sin(angle) * np.cross(n, r)
