"""1 - k^2 below 1e-9 is replaced by zero.

fails: period_grows_to_infinity_at_the_separatrix
names: the period is infinite for omega almost about the middle axis. How near 1 is a k that is not 1?
"""

_right_period = tumble_period


def tumble_period(omega, *, inertia):
    A, B, C = inertia
    p, _, r = omega
    H = np.multiply(inertia, omega)
    near = abs(C * (C - B) * r**2 - A * (B - A) * p**2) < 1e-9 * (H @ H)
    return math.inf if near else _right_period(omega, inertia=inertia)
