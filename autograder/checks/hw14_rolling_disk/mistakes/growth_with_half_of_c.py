"""The growth rate has C/2 where A belongs, as for a thin disk.

fails: growth_rate_is_that_of_a_small_lean
within: 1e-08
"""

_growth = growth_rate_squared


def growth_rate_squared(speed, *, inertia, **disk):
    return _growth(speed, inertia=(inertia[1] / 2, inertia[1]), **disk)
