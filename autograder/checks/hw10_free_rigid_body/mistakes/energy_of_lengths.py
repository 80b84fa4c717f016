"""The energy has the product of the lengths of H and omega where their scalar product belongs.

fails: energy_is_half_omega_h
"""

def energy(omega, *, inertia):
    return 0.5 * np.linalg.norm(np.multiply(inertia, omega)) * np.linalg.norm(omega)
