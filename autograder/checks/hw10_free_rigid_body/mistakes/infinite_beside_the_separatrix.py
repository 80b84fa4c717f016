"""A wide band on both sides of the separatrix is treated as the separatrix.

fails: period_grows_to_infinity_at_the_separatrix
names: the period is infinite for omega next to the separatrix
"""

_right_period = tumble_period


def tumble_period(omega, *, inertia):
    A, B, C = inertia
    p, _, r = omega
    round_0, round_2 = A * (B - A) * p * p, C * (C - B) * r * r
    if p and r and abs(round_0 - round_2) <= 0.1 * (round_0 + round_2):
        return math.inf
    return _right_period(omega, inertia=inertia)
