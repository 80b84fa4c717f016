"""Twice what is right, which is {f} of point masses at the ends of the bars.

fails: velocity_terms_are_centripetal
"""

once = velocity_terms


def velocity_terms(theta, omega, *, masses, lengths):
    return 2 * np.asarray(once(theta, omega, masses=masses, lengths=lengths))
