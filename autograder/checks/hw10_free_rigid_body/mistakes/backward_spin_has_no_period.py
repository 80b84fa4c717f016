"""Pure spin about axis 2 at a negative rate is treated as a motion without period.

fails: period_of_pure_spin_is_that_of_small_oscillations
names: the period is infinite for pure spin about axis 2, at a negative rate
"""

_right_period = tumble_period


def tumble_period(omega, *, inertia):
    if np.count_nonzero(omega) == 1 and omega[2] < 0:
        return math.inf
    return _right_period(omega, inertia=inertia)
