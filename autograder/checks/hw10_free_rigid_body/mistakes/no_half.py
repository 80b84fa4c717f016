"""The energy lacks the factor 1/2.

fails: energy_is_half_omega_h
"""


def energy(omega, *, inertia):
    return np.dot(omega, np.multiply(inertia, omega))
