"""Twice the velocity terms, from a coupling that is differentiated once for each of its two places.

fails: velocity_terms_are_centripetal
suspect: twice what is right
"""

once = velocity_terms


def velocity_terms(theta, omega, *, masses, lengths):
    return 2 * np.asarray(once(theta, omega, masses=masses, lengths=lengths))
