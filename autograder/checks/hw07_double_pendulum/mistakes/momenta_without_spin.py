"""The angular momenta of the bars lack the inertias about their mass centres.

fails: angular_momentum_is_about_the_ceiling
"""

with_spin = angular_momentum


def angular_momentum(theta, omega, *, masses, lengths):
    spin = np.sum(masses * np.square(lengths) * omega) / 12
    return with_spin(theta, omega, masses=masses, lengths=lengths) - spin
