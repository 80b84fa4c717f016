"""The axis is divided by the square of its length.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""

def _unit(axis):
    return axis / np.dot(axis, axis)
