"""The cosine of th1 + th2 stands where the cosine of th1 - th2 belongs.

fails: mass_matrix_makes_the_kinetic_energy, energy_is_kinetic_and_potential, angular_momentum_is_about_the_ceiling
"""

_right = mass_matrix


def mass_matrix(theta, *, masses, lengths):
    return _right([theta[0], -theta[1]], masses=masses, lengths=lengths)
