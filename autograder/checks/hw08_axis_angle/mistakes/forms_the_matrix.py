"""rotate multiplies r by the matrix.

fails: vector_turns_by_the_right_hand_rule
names: rotate uses what is off limits in it: rotation_matrix
"""

def rotate(r, axis, angle):
    return rotation_matrix(axis, angle) @ r
