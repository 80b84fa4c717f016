"""The period's formula belongs to the other side of the separatrix.

fails: period_round_the_first_axis
"""


def tumble_period(omega, *, inertia):
    from scipy.special import ellipkm1

    A, B, C = inertia
    double, square = np.sum(inertia * omega**2), np.sum((inertia * omega) ** 2)
    along = (C - B) * (square - double * A)
    complement = (C - A) * abs(square - double * B) / along
    return 4 * ellipkm1(min(complement, 1.0)) * math.sqrt(A * B * C / along)
