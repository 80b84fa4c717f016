"""phi has the wrong sign.

fails: euler_rates_make_omega
"""

_right_rates = euler_rates_313


def euler_rates_313(angles, omega):
    return _right_rates(np.multiply(angles, [1, 1, -1]), omega)
