"""The second velocity term has the wrong sign.

fails: velocity_terms_are_centripetal
"""

of_both_signs = velocity_terms


def velocity_terms(theta, omega, *, masses, lengths):
    return of_both_signs(theta, omega, masses=masses, lengths=lengths) * [1, -1]
