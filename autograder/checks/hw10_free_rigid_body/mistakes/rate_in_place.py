"""attitude_rate writes its result into the given R.

fails: attitude_follows_omega
names: attitude_rate changes the arrays
"""

_right_rate = attitude_rate


def attitude_rate(R, omega):
    R[:] = _right_rate(R, omega)
    return R
