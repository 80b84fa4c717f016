"""Stable where it is unstable.

fails: growth_rate_is_that_of_a_small_lean
suspect: the sign turned round
"""


_growth = growth_rate_squared


def growth_rate_squared(speed, **disk):
    return -_growth(speed, **disk)
