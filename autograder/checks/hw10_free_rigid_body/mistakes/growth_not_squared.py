"""The result is the growth rate; its square is asked for.

fails: small_deviations_grow_at_this_rate
"""

_right_growth = growth_rate_squared


def growth_rate_squared(axis, spin, *, inertia):
    square = _right_growth(axis, spin, inertia=inertia)
    return math.copysign(math.sqrt(abs(square)), square)
