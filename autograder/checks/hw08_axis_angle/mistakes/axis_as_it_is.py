"""The axis is not made a unit vector.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""

def _unit(axis):
    return np.array(axis)
