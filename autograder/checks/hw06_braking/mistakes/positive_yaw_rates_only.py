"""The yaw rate loses its sign.

fails: small_yaw_rate_is_the_linear_solution
"""

_right = small_yaw_rate


def small_yaw_rate(speed, speed0, yaw_rate0, locked, **car):
    return abs(_right(speed, speed0, yaw_rate0, locked, **car))
