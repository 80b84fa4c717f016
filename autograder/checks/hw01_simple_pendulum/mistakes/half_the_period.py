"""This is half the period; the pendulum should also come back.

fails: period_is_exact
"""

_right_period = period


def period(amplitude, **rod):
    return _right_period(amplitude, **rod) / 2
