"""The angles psi and phi are exchanged: phi is about the body's own axis.

fails: euler_rates_make_omega
"""


def euler_rates_313(angles, omega):
    psi, theta, _ = angles
    p, q, r = omega
    s = math.sin(theta)
    if abs(s) < 1e-12:
        raise ValueError("theta is 0 or pi")
    phi_rate = (p * math.sin(psi) + q * math.cos(psi)) / s
    return np.array([r - phi_rate * math.cos(theta), p * math.cos(psi) - q * math.sin(psi), phi_rate])
