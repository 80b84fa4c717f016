"""The momentum conjugate to th2 is taken for the angular momentum of both bars.

fails: angular_momentum_is_about_the_ceiling
suspect: the momentum conjugate to th2
"""


def angular_momentum(theta, omega, *, masses, lengths):
    return (mass_matrix(theta, masses=masses, lengths=lengths) @ omega)[1]
