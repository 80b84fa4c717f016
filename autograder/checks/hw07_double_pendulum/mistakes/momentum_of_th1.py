"""The angular momentum is only the momentum conjugate to th1; the momentum conjugate to th2 belongs to it, too.

fails: angular_momentum_is_about_the_ceiling
"""


def angular_momentum(theta, omega, *, masses, lengths):
    return (mass_matrix(theta, masses=masses, lengths=lengths) @ omega)[0]
