"""A sine of theta below 1e-6 is replaced by 1e-6.

fails: euler_rates_are_refused_where_undetermined
"""

_right_rates_313 = euler_rates_313


def euler_rates_313(angles, omega):
    psi_rate, theta_rate, phi_rate = _right_rates_313(angles, omega)
    s = abs(math.sin(angles[1]))
    less = psi_rate * (1 - min(s / 1e-6, 1.0))
    return np.array([psi_rate - less, theta_rate, phi_rate + less * math.cos(angles[1])])
