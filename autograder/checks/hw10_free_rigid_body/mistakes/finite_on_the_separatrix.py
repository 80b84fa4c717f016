"""The modulus is kept below one.

fails: period_grows_to_infinity_at_the_separatrix
names: the period is not infinite for pure spin about the middle axis
"""

_right_period = tumble_period


def tumble_period(omega, *, inertia):
    return min(_right_period(omega, inertia=inertia), 1e6)
