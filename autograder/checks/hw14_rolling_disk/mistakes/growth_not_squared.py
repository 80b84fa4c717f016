"""This is the rate, or the frequency; its square is asked for, negative where the lean swings.

fails: growth_rate_is_that_of_a_small_lean
"""

_squared = growth_rate_squared


def growth_rate_squared(speed, **disk):
    return math.sqrt(abs(_squared(speed, **disk)))
