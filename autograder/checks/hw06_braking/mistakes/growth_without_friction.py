"""Friction left out of the growth rate.

fails: growth_rate_is_the_slope
suspect: friction left out
"""

_right = yaw_growth_rate


def yaw_growth_rate(speed, locked, *, friction, **car):
    return _right(speed, locked, friction=0.0, **car)
