"""The integral turned to a positive parameter, without the factor that this brings.

fails: period_is_exact
suspect: the factor before the integral
"""

def period(amplitude, *, curvature, gravity):
    from scipy.special import ellipe

    k = 2 * curvature * amplitude
    return 4 * ellipe(k**2 / (1 + k**2)) / math.sqrt(2 * gravity * curvature)
