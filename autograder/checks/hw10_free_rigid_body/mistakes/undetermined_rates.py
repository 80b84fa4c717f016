"""Where sin theta is zero the rates are very large numbers; they should raise ValueError.

fails: euler_rates_are_refused_where_undetermined
names: euler_rates_313 does not raise ValueError for theta = 0
"""


def euler_rates_313(angles, omega):
    _, theta, phi = angles
    p, q, r = omega
    psi_rate = (p * math.sin(phi) + q * math.cos(phi)) / (math.sin(theta) or 1e-300)
    return np.array([psi_rate, p * math.cos(phi) - q * math.sin(phi), r - psi_rate * math.cos(theta)])
