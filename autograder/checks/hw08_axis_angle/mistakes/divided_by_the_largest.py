"""The axis is divided by its largest component, not by its length.

fails: matrix_turns_by_the_right_hand_rule, vector_turns_by_the_right_hand_rule
"""

_right_unit = _unit


def _unit(axis):
    return axis / np.abs(axis).max() if np.any(axis) and np.isfinite(axis).all() else _right_unit(axis)
