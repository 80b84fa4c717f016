"""The growth rate squared has the wrong sign.

fails: small_deviations_grow_at_this_rate
"""

_right_growth = growth_rate_squared


def growth_rate_squared(axis, spin, *, inertia):
    return -_right_growth(axis, spin, inertia=inertia)
