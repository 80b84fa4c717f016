"""The matrix of the last turn is transposed: -phi for phi.

fails: euler_rates_make_omega
suspect: phi of the other sign
"""

_right_rates = euler_rates_313


def euler_rates_313(angles, omega):
    return _right_rates(np.multiply(angles, [1, 1, -1]), omega)
