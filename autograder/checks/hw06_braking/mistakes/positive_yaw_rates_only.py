"""The size of the yaw rate.

fails: small_yaw_rate_is_the_linear_solution
suspect: the yaw rate without its sign
"""

_right = small_yaw_rate


def small_yaw_rate(speed, speed0, yaw_rate0, locked, **car):
    return abs(_right(speed, speed0, yaw_rate0, locked, **car))
