"""M11 has m1 l1^2/12 where m1 l1^2/3 belongs.

fails: mass_matrix_makes_the_kinetic_energy, energy_is_kinetic_and_potential, angular_momentum_is_about_the_ceiling
"""

_right = mass_matrix


def mass_matrix(theta, *, masses, lengths):
    return _right(theta, masses=masses, lengths=lengths) - np.diag([masses[0] * lengths[0] ** 2 / 4, 0.0])
