"""ellipk gets the modulus k; SciPy's takes the parameter m = k^2.

fails: period_round_the_last_axis, period_round_the_first_axis
"""


def tumble_period(omega, *, inertia):
    from scipy.special import ellipk

    A, B, C = inertia
    double, square = np.sum(inertia * omega**2), np.sum((inertia * omega) ** 2)
    if square < double * B:
        A, C = C, A
    along = (C - B) * (square - double * A)
    return 4 * ellipk(math.sqrt((B - A) * (double * C - square) / along)) * math.sqrt(A * B * C / along)
