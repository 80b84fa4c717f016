"""The velocity of bar 2's mass centre is put together without the angle between its parts.

fails: energy_is_kinetic_and_potential
suspect: without its term with om1 om2
"""

_right = energy


def energy(theta, omega, *, masses, lengths, gravity):
    coupling = mass_matrix(theta, masses=masses, lengths=lengths)[0, 1]
    return (
        _right(theta, omega, masses=masses, lengths=lengths, gravity=gravity) - coupling * omega[0] * omega[1]
    )
