"""The force of bar 2 is left out of bar 1's linear momentum balance.

fails: free_bars_accelerate_as_lagranges
"""

_right = _balances_and_constraints


def _balances_and_constraints(along, across, masses):
    matrix = _right(along, across, masses)
    matrix[G1, ELBOW] = 0.0
    return matrix
