"""You used the transpose of R; dR/dt is R omega-hat.

fails: attitude_follows_omega
"""

_rate = attitude_rate


def attitude_rate(R, omega):
    return _rate(np.transpose(R), omega)
