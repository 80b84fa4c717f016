"""Rates are refused where sin theta is 1e-6.

fails: euler_rates_are_refused_where_undetermined
names: euler_rates_313 raised ValueError for sin theta small, but not below 1e-12
"""

_right_rates_313 = euler_rates_313


def euler_rates_313(angles, omega):
    if abs(math.sin(angles[1])) < 1e-6:
        raise ValueError
    return _right_rates_313(angles, omega)
