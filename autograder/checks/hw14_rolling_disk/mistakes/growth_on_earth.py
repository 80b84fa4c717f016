"""9.81 m/s^2 for gravity in the growth rate.

fails: growth_rate_is_that_of_a_small_lean
suspect: 9.81 m/s^2
"""

_growth = growth_rate_squared


def growth_rate_squared(speed, *, gravity, **disk):
    return _growth(speed, gravity=9.81, **disk)
