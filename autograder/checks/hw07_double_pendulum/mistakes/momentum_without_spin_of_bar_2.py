"""The angular momentum lacks I om2 of bar 2.

fails: angular_momentum_is_about_the_ceiling
"""

_right = angular_momentum


def angular_momentum(theta, omega, *, masses, lengths):
    spin = masses[1] * lengths[1] ** 2 / 12 * omega[1]
    return _right(theta, omega, masses=masses, lengths=lengths) - spin
