"""The axis not made a unit vector in the sin th term.

fails: vector_turns_by_the_right_hand_rule
"""


def rotate(r, axis, angle):
    n = _unit(axis)
    return np.cos(angle) * r + _versine(angle) * np.dot(n, r) * n + np.sin(angle) * np.cross(axis, r)
