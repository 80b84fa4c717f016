"""The factor sqrt(1 + (2 c A)^2) before the integral is missing.

fails: period_is_exact
"""

def period(amplitude, *, curvature, gravity):
    from scipy.special import ellipe

    k = 2 * curvature * amplitude
    return 4 * ellipe(k**2 / (1 + k**2)) / math.sqrt(2 * gravity * curvature)
