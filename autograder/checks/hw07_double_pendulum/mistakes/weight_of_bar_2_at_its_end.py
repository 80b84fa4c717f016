"""The weight of bar 2 has the lever l2.

fails: gravity_terms_are_moments_of_the_weights
suspect: m2 g l2 in the second one
"""

_right = gravity_terms


def gravity_terms(theta, *, masses, lengths, gravity):
    return _right(theta, masses=masses, lengths=lengths, gravity=gravity) * [1, 2]
