"""The growth rate squared has the wrong sign.

fails: growth_rate_is_that_of_a_small_lean
"""


_growth = growth_rate_squared


def growth_rate_squared(speed, **disk):
    return -_growth(speed, **disk)
