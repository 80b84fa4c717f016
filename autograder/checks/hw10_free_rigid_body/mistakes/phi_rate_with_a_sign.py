"""The sign of psi' cos(theta) in phi' is wrong.

fails: euler_rates_make_omega
"""

_right_rates = euler_rates_313


def euler_rates_313(angles, omega):
    psi, theta, phi = angles
    psi_rate, theta_rate, phi_rate = _right_rates(angles, omega)
    return np.array([psi_rate, theta_rate, omega[2] + psi_rate * math.cos(theta)])
