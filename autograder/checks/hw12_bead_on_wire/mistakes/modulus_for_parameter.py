"""SciPy's ellipe given the modulus k, where it takes the parameter k^2.

fails: period_is_exact
suspect: the modulus for the parameter
"""

def period(amplitude, *, curvature, gravity):
    from scipy.special import ellipe

    k = 2 * curvature * amplitude
    return 4 * math.hypot(1, k) * ellipe(k / math.hypot(1, k)) / math.sqrt(2 * gravity * curvature)
