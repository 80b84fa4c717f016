"""Gravity pulls back by the absolute value of the sine.

fails: gravity_terms_are_moments_of_the_weights
suspect: never negative
"""

signed = gravity_terms


def gravity_terms(theta, **known):
    return np.abs(signed(theta, **known))
