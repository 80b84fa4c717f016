"""The rates come in the order phi, theta, psi; it should be psi, theta, phi.

fails: euler_rates_make_omega
"""

_right_rates_313 = euler_rates_313


def euler_rates_313(angles, omega):
    return _right_rates_313(angles, omega)[::-1]
