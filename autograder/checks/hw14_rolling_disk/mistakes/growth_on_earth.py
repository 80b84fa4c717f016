"""The gravity is 9.81 m/s^2, whatever is given.

fails: growth_rate_is_that_of_a_small_lean
"""

_growth = growth_rate_squared


def growth_rate_squared(speed, *, gravity, **disk):
    return _growth(speed, gravity=9.81, **disk)
