"""The period's formula holds round the axis of the largest inertia; on the other side its k is above one.

fails: period_round_the_first_axis
names: tumble_period returned NaN or infinity for omega round the axis of the smallest inertia
"""


def tumble_period(omega, *, inertia):
    from scipy.special import ellipk

    A, B, C = inertia
    double, square = np.sum(inertia * omega**2), np.sum((inertia * omega) ** 2)
    along = (C - B) * (square - double * A)
    return 4 * ellipk((B - A) * (double * C - square) / along) * math.sqrt(A * B * C / along)
