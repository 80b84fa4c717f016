"""The axis not made a unit vector.

fails: vector_turns_by_the_right_hand_rule, rotate_refuses_what_is_no_axis
also: the axis not made a unit vector in the sin th term | the axis not made a unit vector in the (1 - cos th) term | the axis not made a unit vector in n . r
"""


def rotate(r, axis, angle):
    n = axis
    a = angle
    return np.cos(a) * r + (1 - np.cos(a)) * np.dot(n, r) * n + np.sin(a) * np.cross(n, r)
