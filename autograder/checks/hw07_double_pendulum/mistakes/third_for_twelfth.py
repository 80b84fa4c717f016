"""The inertia about a bar's own centre is m l^2/3; it should be m l^2/12.

fails: free_bars_accelerate_as_lagranges
"""

right_inertias = _balances_and_constraints


def _balances_and_constraints(along, across, masses):
    matrix = right_inertias(along, across, masses)
    matrix[4, 4] *= 4
    matrix[5, 5] *= 4
    return matrix
