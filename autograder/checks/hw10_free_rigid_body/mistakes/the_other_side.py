"""The period's formula belongs to the other side of the separatrix.

fails: period_round_the_last_axis
"""


def tumble_period(omega, *, inertia):
    from scipy.special import ellipk

    C, B, A = inertia
    double, square = np.sum(inertia * omega**2), np.sum((inertia * omega) ** 2)
    along = (C - B) * (square - double * A)
    m = (B - A) * (double * C - square) / along
    return 4 * ellipk(m if m < 1 else 1 / m) * math.sqrt(A * B * C / along)
