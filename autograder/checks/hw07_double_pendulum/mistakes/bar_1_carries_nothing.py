"""The weight of bar 2 is left out of the first one.

fails: gravity_terms_are_moments_of_the_weights
"""


def gravity_terms(theta, *, masses, lengths, gravity):
    return gravity * masses * lengths / 2 * np.sin(theta)
