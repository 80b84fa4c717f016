"""The axis is divided by the sum of its components' sizes, not by its length.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""

_right_unit = _unit


def _unit(axis):
    return axis / np.abs(axis).sum() if np.any(axis) and np.isfinite(axis).all() else _right_unit(axis)
