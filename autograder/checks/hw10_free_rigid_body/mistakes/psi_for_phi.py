"""The angles psi and phi are exchanged: phi is about the body's own axis.

fails: euler_rates_make_omega
"""

_right = euler_rates_313


def euler_rates_313(angles, omega):
    return np.asarray(_right(np.asarray(angles)[::-1], omega))[::-1]
