"""growth_rate_squared sorts the inertias first.

fails: small_deviations_grow_at_this_rate
suspect: the inertias put in order first
"""

_right_growth = growth_rate_squared


def growth_rate_squared(axis, spin, *, inertia):
    return _right_growth(axis, spin, inertia=sorted(inertia))
