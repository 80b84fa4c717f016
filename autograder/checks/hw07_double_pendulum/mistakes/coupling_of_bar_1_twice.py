"""The coupling has l1^2 where l1 l2 belongs.

fails: mass_matrix_makes_the_kinetic_energy, energy_is_kinetic_and_potential, angular_momentum_is_about_the_ceiling
"""

of_both_lengths = mass_matrix


def mass_matrix(theta, *, masses, lengths):
    M = of_both_lengths(theta, masses=masses, lengths=lengths)
    return M * [[1, lengths[0] / lengths[1]], [lengths[0] / lengths[1], 1]]
