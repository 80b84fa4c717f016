"""The result is the square of the critical speed.

fails: critical_speed_is_where_growth_begins, stability_refuses_other_axles
"""

_right = critical_speed


def critical_speed(locked, **car):
    return _right(locked, **car) ** 2
