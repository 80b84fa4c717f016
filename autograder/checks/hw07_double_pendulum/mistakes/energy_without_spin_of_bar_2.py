"""The kinetic energy lacks the turning of bar 2, I om2^2/2.

fails: energy_is_kinetic_and_potential
"""

_right = energy


def energy(theta, omega, *, masses, lengths, gravity):
    spin = masses[1] * lengths[1] ** 2 / 24 * omega[1] ** 2
    return _right(theta, omega, masses=masses, lengths=lengths, gravity=gravity) - spin
