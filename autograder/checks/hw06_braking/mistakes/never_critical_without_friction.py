"""Without friction the critical speed is infinite; it should be zero.

fails: critical_speed_is_where_growth_begins
"""

_right = critical_speed


def critical_speed(locked, **car):
    return _right(locked, **car) or math.inf
