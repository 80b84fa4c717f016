"""Every velocity term is twice what is right.

fails: velocity_terms_are_centripetal
also: The masses are points at the ends of the bars
"""

once = velocity_terms


def velocity_terms(theta, omega, *, masses, lengths):
    return 2 * np.asarray(once(theta, omega, masses=masses, lengths=lengths))
