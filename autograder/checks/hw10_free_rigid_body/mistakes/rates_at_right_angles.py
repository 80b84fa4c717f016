"""Where theta is a right angle, psi' is set to zero, because a division by the cosine is left out.

fails: euler_rates_make_omega
"""

_right = euler_rates_313


def euler_rates_313(angles, omega):
    rates = np.array(_right(angles, omega))
    return rates * [abs(math.cos(angles[1])) > 1e-12, 1, 1]
