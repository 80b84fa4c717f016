"""The energy is omega . H.

fails: energy_is_half_omega_h
suspect: an energy without the half
"""


def energy(omega, *, inertia):
    return np.dot(omega, np.multiply(inertia, omega))
