"""The angular momentum lacks the terms that couple the bars.

fails: angular_momentum_is_about_the_ceiling
"""


def angular_momentum(theta, omega, *, masses, lengths):
    return np.diag(mass_matrix(theta, masses=masses, lengths=lengths)) @ omega
