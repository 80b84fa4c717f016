"""A small number is added to the mass matrix before it is inverted, which swamps a light bar.

fails: accelerations_with_a_nearly_massless_bar
names: Is anything added to the masses
"""


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    loads = velocity_terms(theta, omega, masses=masses, lengths=lengths)
    loads = loads + gravity_terms(theta, masses=masses, lengths=lengths, gravity=gravity)
    M = mass_matrix(theta, masses=masses, lengths=lengths)
    return -np.linalg.solve(M + 1e-11 * np.eye(2), loads)
