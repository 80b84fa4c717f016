"""2 K for 4 K: omega is back but for two signs.

fails: period_round_the_last_axis, period_round_the_first_axis
suspect: half of the period
"""

_right_period = tumble_period


def tumble_period(omega, *, inertia):
    return _right_period(omega, inertia=inertia) / 2
