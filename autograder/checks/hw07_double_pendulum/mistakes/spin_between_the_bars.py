"""om2 - om1 stands for the rate at which bar 2 turns.

fails: energy_is_kinetic_and_potential
"""

of_absolute_rates = energy


def energy(theta, omega, *, masses, lengths, gravity):
    spin = masses[1] * lengths[1] ** 2 / 24 * ((omega[1] - omega[0]) ** 2 - omega[1] ** 2)
    return of_absolute_rates(theta, omega, masses=masses, lengths=lengths, gravity=gravity) + spin
