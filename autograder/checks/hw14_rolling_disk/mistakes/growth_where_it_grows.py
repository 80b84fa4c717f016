"""The growth rate squared is 0 where the motion is stable; it should be negative.

fails: growth_rate_is_that_of_a_small_lean
"""


_growth = growth_rate_squared


def growth_rate_squared(speed, **disk):
    return max(_growth(speed, **disk), 0.0)
