"""A growth rate below zero is cut off to zero.

fails: growth_rate_is_the_slope
"""

_right = yaw_growth_rate


def yaw_growth_rate(speed, locked, **car):
    return max(_right(speed, locked, **car), 0.0)
