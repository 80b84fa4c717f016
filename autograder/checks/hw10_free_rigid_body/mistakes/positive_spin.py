"""The square of the spin has the sign of the spin.

fails: small_deviations_grow_at_this_rate
"""

_right_growth = growth_rate_squared


def growth_rate_squared(axis, spin, *, inertia):
    return _right_growth(axis, 1.0, inertia=inertia) * spin * abs(spin)
