"""The weight of bar 2 does not turn bar 1.

fails: gravity_terms_are_moments_of_the_weights
suspect: the weight of bar 2 left out
"""


def gravity_terms(theta, *, masses, lengths, gravity):
    return gravity * masses * lengths / 2 * np.sin(theta)
