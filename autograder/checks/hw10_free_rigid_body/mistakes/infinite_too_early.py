"""1 - k^2 below 1e-5 is replaced by zero.

fails: period_grows_to_infinity_at_the_separatrix
names: the period is infinite for omega almost about the middle axis
"""

_right_period = tumble_period


def tumble_period(omega, *, inertia):
    H = np.multiply(inertia, omega)
    return math.inf if math.isclose(H @ H, inertia[1] * (H @ omega), rel_tol=1e-5) else _right_period(omega, inertia=inertia)
