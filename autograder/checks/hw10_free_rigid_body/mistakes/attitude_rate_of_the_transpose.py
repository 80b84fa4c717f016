"""R omega-hat has the transpose of R.

fails: attitude_follows_omega
"""

_rate = attitude_rate


def attitude_rate(R, omega):
    return _rate(np.transpose(R), omega)
