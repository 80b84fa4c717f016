"""The coupling has 1 - (th1 - th2)^2/2 for the cosine, which holds only for small angles.

fails: mass_matrix_makes_the_kinetic_energy, energy_is_kinetic_and_potential, angular_momentum_is_about_the_ceiling
"""

of_any_angles = mass_matrix


def mass_matrix(theta, *, masses, lengths):
    M = np.array(of_any_angles(theta, masses=masses, lengths=lengths))
    M[0, 1] = M[1, 0] = masses[1] * lengths[0] * lengths[1] / 2 * (1 - (theta[0] - theta[1]) ** 2 / 2)
    return M
