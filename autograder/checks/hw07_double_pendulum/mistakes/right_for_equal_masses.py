"""Both bars are given the mass of bar 2.

fails: accelerations_obey_the_equations
"""

unequal = angular_acceleration


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    return unequal(theta, omega, masses=masses[[1, 1]], lengths=lengths, gravity=gravity)
