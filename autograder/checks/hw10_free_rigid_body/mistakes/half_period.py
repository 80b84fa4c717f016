"""The result is half of the period.

fails: period_round_the_last_axis, period_round_the_first_axis
"""

_right_period = tumble_period


def tumble_period(omega, *, inertia):
    return _right_period(omega, inertia=inertia) / 2
