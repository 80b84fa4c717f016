"""At speed = speed0 you return 0; return yaw_rate0.

fails: small_yaw_rate_is_the_linear_solution
"""

_right = small_yaw_rate


def small_yaw_rate(speed, speed0, yaw_rate0, locked, **car):
    return _right(speed, speed0, yaw_rate0, locked, **car) if speed < speed0 else 0.0
