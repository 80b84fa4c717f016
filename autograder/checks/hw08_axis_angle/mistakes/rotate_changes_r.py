"""rotate works in place.

fails: vector_turns_by_the_right_hand_rule
names: rotate changes the arrays
"""


def rotate(r, axis, angle):
    r[:] = rotation_matrix(axis, angle) @ r
    return r
