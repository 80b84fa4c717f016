"""This is a quarter of the period: the time from the top of the swing to the bottom.

fails: period_is_exact
"""

_right_period = period


def period(amplitude, **rod):
    return _right_period(amplitude, **rod) / 4
