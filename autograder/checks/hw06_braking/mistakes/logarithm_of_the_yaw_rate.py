"""The yaw rate comes from its logarithm, which only a positive one has.

fails: small_yaw_rate_is_the_linear_solution
"""

_right = small_yaw_rate


def small_yaw_rate(speed, speed0, yaw_rate0, locked, **car):
    return _right(speed, speed0, yaw_rate0 if yaw_rate0 > 0 else math.nan, locked, **car)
