"""sin theta comes from a square root, which is right only for theta from 0 to pi.

fails: euler_rates_make_omega
"""


def euler_rates_313(angles, omega):
    _, theta, phi = angles
    c = math.cos(theta)
    s = math.sqrt(1 - c * c)
    if abs(s) < 1e-12:
        raise ValueError
    psi_rate = (omega[0] * math.sin(phi) + omega[1] * math.cos(phi)) / s
    return np.array([psi_rate, omega[0] * math.cos(phi) - omega[1] * math.sin(phi), omega[2] - psi_rate * c])
