"""omega-hat R stands for R omega-hat, but omega is in body components.

fails: attitude_follows_omega
"""


def attitude_rate(R, omega):
    p, q, r = omega
    return np.array([[0.0, -r, q], [r, 0.0, -p], [-q, p, 0.0]]) @ R
