"""Friction's part of the growth rate has the wrong sign.

fails: growth_rate_is_the_slope
"""

_right = yaw_growth_rate


def yaw_growth_rate(speed, locked, *, friction, **car):
    return _right(speed, locked, friction=-friction, **car)
