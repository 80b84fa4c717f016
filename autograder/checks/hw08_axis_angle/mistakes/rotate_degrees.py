"""The angle taken for degrees.

fails: vector_turns_by_the_right_hand_rule
"""


def rotate(r, axis, angle):
    n = _unit(axis)
    a = np.radians(angle)
    return np.cos(a) * r + (1 - np.cos(a)) * np.dot(n, r) * n + np.sin(a) * np.cross(n, r)
