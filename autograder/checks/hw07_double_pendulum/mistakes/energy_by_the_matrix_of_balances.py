"""Your [M] is that of angular momentum balances; half of omega . M omega is the kinetic energy for Lagrange's alone.

fails: energy_is_kinetic_and_potential, angular_momentum_is_about_the_ceiling
"""

TO_BALANCES = np.array([[1, 1], [0, 1]])  # of both bars about the ceiling, of bar 2 about the elbow
lagranges = mass_matrix, velocity_terms, gravity_terms


def mass_matrix(theta, *, masses, lengths):
    return TO_BALANCES @ lagranges[0](theta, masses=masses, lengths=lengths)


def velocity_terms(theta, omega, *, masses, lengths):
    return TO_BALANCES @ lagranges[1](theta, omega, masses=masses, lengths=lengths)


def gravity_terms(theta, *, masses, lengths, gravity):
    return TO_BALANCES @ lagranges[2](theta, masses=masses, lengths=lengths, gravity=gravity)
