"""The axis not made a unit vector.

fails: matrix_turns_by_the_right_hand_rule, matrix_refuses_what_is_no_axis
also: the axis not made a unit vector in the sin th term | the axis not made a unit vector in the (1 - cos th) term | the axis not made a unit vector in n . r
"""


def rotation_matrix(axis, angle):
    n = axis
    a = angle
    return np.cos(a) * np.eye(3) + (1 - np.cos(a)) * np.outer(n, n) + np.sin(a) * skew(n)
