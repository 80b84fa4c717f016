"""Pure spin about a stable axis is treated as a motion without period.

fails: period_of_pure_spin_is_that_of_small_oscillations
names: the period is infinite for pure spin about axis 0
"""

_right_period = tumble_period


def tumble_period(omega, *, inertia):
    return _right_period(omega, inertia=inertia) if np.count_nonzero(omega) > 1 else math.inf
