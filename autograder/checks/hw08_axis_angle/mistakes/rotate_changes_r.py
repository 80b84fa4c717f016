"""rotate changes the given r in place; work on a copy.

fails: vector_turns_by_the_right_hand_rule
names: rotate changes the arrays
"""

_vector = rotate


def rotate(r, axis, angle):
    r[:] = _vector(r, axis, angle)
    return r
