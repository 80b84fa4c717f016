"""attitude_rate multiplies the transpose of R.

fails: attitude_follows_omega
suspect: the transpose of R in R omega-hat
"""

_rate = attitude_rate


def attitude_rate(R, omega):
    return _rate(np.transpose(R), omega)
