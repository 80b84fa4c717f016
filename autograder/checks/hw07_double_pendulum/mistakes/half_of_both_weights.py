"""Gravity's first term has (m1 + m2)/2 where m1/2 + m2 belongs.

fails: gravity_terms_are_moments_of_the_weights
"""

_right = gravity_terms


def gravity_terms(theta, *, masses, lengths, gravity):
    one, two = _right(theta, masses=masses, lengths=lengths, gravity=gravity)
    return [one - masses[1] / 2 * gravity * lengths[0] * math.sin(theta[0]), two]
