"""The bars' angular momenta about their own mass centres are left out.

fails: angular_momentum_is_about_the_ceiling
suspect: without inertia
"""

with_spin = angular_momentum


def angular_momentum(theta, omega, *, masses, lengths):
    spin = np.sum(masses * np.square(lengths) * omega) / 12
    return with_spin(theta, omega, masses=masses, lengths=lengths) - spin
