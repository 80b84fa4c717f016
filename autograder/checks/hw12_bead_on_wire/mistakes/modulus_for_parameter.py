"""ellipe gets the modulus k; SciPy's takes the parameter k^2.

fails: period_is_exact
"""

def period(amplitude, *, curvature, gravity):
    from scipy.special import ellipe

    k = 2 * curvature * amplitude
    return 4 * math.hypot(1, k) * ellipe(k / math.hypot(1, k)) / math.sqrt(2 * gravity * curvature)
