"""1 - k below a millionth is replaced by zero, unless p or r is zero.

fails: period_grows_to_infinity_at_the_separatrix
names: the period is infinite for omega next to the separatrix
"""

_right_period = tumble_period


def tumble_period(omega, *, inertia):
    A, B, C = inertia
    p, _, r = omega
    if math.isclose(A * (B - A) * p * p, C * (C - B) * r * r, rel_tol=2e-6):
        return math.inf
    return _right_period(omega, inertia=inertia)
