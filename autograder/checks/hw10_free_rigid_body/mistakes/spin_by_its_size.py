"""The growth rate squared has the spin where its square belongs.

fails: small_deviations_grow_at_this_rate
"""

_growth = growth_rate_squared


def growth_rate_squared(axis, spin, *, inertia):
    return abs(spin) * _growth(axis, 1.0, inertia=inertia)
