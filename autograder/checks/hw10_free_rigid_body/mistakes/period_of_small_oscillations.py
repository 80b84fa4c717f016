"""This is the period of small oscillations about axis 2; it should depend on how far omega swings.

fails: period_round_the_last_axis, period_round_the_first_axis
where: the largest inertia
"""


def tumble_period(omega, *, inertia):
    A, B, C = inertia
    return 2 * math.pi / abs(omega[2]) * math.sqrt(A * B / ((C - A) * (C - B))) if omega[2] else math.inf
