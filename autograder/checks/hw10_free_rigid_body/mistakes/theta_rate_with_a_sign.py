"""The sign of omega_2 sin(phi) in theta' is wrong.

fails: euler_rates_make_omega
"""

_right_rates = euler_rates_313


def euler_rates_313(angles, omega):
    psi, theta, phi = angles
    psi_rate, theta_rate, phi_rate = _right_rates(angles, omega)
    return np.array([psi_rate, omega[0] * math.cos(phi) + omega[1] * math.sin(phi), phi_rate])
