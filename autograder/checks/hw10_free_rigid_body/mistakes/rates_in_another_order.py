"""The rates come as phi, theta, psi.

fails: euler_rates_make_omega
suspect: the rates in the order phi, theta, psi
"""

_right_rates_313 = euler_rates_313


def euler_rates_313(angles, omega):
    return _right_rates_313(angles, omega)[::-1]
