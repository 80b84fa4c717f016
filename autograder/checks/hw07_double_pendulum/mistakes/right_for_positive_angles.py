"""The moments are never negative: the sine has lost its sign.

fails: gravity_terms_are_moments_of_the_weights
"""

signed = gravity_terms


def gravity_terms(theta, **known):
    return np.abs(signed(theta, **known))
