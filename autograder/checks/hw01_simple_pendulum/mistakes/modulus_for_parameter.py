"""ellipk gets the modulus k; SciPy's takes the parameter m = k^2.

fails: period_is_exact
"""

def period(amplitude, *, length, gravity):
    from scipy.special import ellipk

    return 4 * math.sqrt(length / gravity) * ellipk(math.sin(amplitude / 2))
