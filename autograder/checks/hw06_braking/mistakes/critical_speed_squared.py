"""The square of the critical speed.

fails: critical_speed_is_where_growth_begins
suspect: square of the speed
"""

_right = critical_speed


def critical_speed(locked, **car):
    return _right(locked, **car) ** 2
