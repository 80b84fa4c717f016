"""Gravity's first term leaves out the weight of bar 2.

fails: gravity_terms_are_moments_of_the_weights
"""


def gravity_terms(theta, *, masses, lengths, gravity):
    return gravity * masses * lengths / 2 * np.sin(theta)
