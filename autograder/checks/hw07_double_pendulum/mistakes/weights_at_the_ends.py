"""Each weight acts at the end of its bar; it belongs at the middle.

fails: energy_is_kinetic_and_potential
"""


def energy(theta, omega, *, masses, lengths, gravity):
    y = np.cumsum(-np.asarray(lengths) * np.cos(theta))
    return omega @ mass_matrix(theta, masses=masses, lengths=lengths) @ omega / 2 + gravity * (masses @ y)
