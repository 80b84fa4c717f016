"""Bar 2 does not pull at bar 1 in the linear momentum balance of bar 1.

fails: free_bars_accelerate_as_lagranges
suspect: the force of bar 2 left out
"""

_right = _balances_and_constraints


def _balances_and_constraints(along, across, masses):
    matrix = _right(along, across, masses)
    matrix[G1, ELBOW] = 0.0
    return matrix
