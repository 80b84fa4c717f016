"""The angular momentum is taken for the momentum conjugate to th1.

fails: angular_momentum_is_about_the_ceiling
suspect: conjugate to th1 alone
"""


def angular_momentum(theta, omega, *, masses, lengths):
    return (mass_matrix(theta, masses=masses, lengths=lengths) @ omega)[0]
