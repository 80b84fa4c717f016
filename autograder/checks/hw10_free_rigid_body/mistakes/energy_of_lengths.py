"""The energy is |H| |omega| / 2.

fails: energy_is_half_omega_h
suspect: the product of the lengths
"""

def energy(omega, *, inertia):
    return 0.5 * np.linalg.norm(np.multiply(inertia, omega)) * np.linalg.norm(omega)
