"""The mass matrix has m l^2/12 where m l^2/3 belongs.

fails: mass_matrix_makes_the_kinetic_energy, energy_is_kinetic_and_potential, angular_momentum_is_about_the_ceiling
"""


def mass_matrix(theta, *, masses, lengths):
    m1, m2 = masses
    l1, l2 = lengths
    coupling = m2 * l1 * l2 / 2 * math.cos(theta[0] - theta[1])
    return np.array([[(m1 / 12 + m2) * l1**2, coupling], [coupling, m2 * l2**2 / 12]])
