"""The axis is a unit vector in the (1 - cos th) term alone.

fails: vector_turns_by_the_right_hand_rule
suspect: the axis not made a unit vector in the sin th term
"""


def rotate(r, axis, angle):
    n = _unit(axis)
    return np.cos(angle) * r + _versine(angle) * np.dot(n, r) * n + np.sin(angle) * np.cross(axis, r)
