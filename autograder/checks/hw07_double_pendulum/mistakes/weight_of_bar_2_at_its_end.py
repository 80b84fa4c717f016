"""Gravity's second term has m2 g l2 where m2 g l2/2 belongs.

fails: gravity_terms_are_moments_of_the_weights
"""

_right = gravity_terms


def gravity_terms(theta, *, masses, lengths, gravity):
    return _right(theta, masses=masses, lengths=lengths, gravity=gravity) * [1, 2]
