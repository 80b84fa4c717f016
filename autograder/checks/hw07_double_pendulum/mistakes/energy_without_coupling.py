"""The kinetic energy lacks its term with om1 om2.

fails: energy_is_kinetic_and_potential
"""

_right = energy


def energy(theta, omega, *, masses, lengths, gravity):
    coupling = mass_matrix(theta, masses=masses, lengths=lengths)[0, 1]
    return (
        _right(theta, omega, masses=masses, lengths=lengths, gravity=gravity) - coupling * omega[0] * omega[1]
    )
