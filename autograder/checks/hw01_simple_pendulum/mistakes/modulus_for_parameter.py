"""SciPy's ellipk takes the parameter m = k^2, not the modulus k.

fails: period_is_exact
"""

def period(amplitude, *, length, gravity):
    from scipy.special import ellipk

    return 4 * math.sqrt(length / gravity) * ellipk(math.sin(amplitude / 2))
