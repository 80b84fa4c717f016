"""The lengths are 1 m, whatever is given.

fails: velocity_terms_are_centripetal
"""


def velocity_terms(theta, omega, *, masses, lengths):
    lever = masses[1] / 2 * math.sin(theta[0] - theta[1])
    return np.array([lever * omega[1] ** 2, -lever * omega[0] ** 2])
