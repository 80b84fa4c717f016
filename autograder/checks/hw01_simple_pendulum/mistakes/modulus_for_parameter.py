"""SciPy's ellipk takes m = k^2, and gets k.

fails: period_is_exact
suspect: the modulus k for the parameter m = k^2
"""

def period(amplitude, *, length, gravity):
    from scipy.special import ellipk

    return 4 * math.sqrt(length / gravity) * ellipk(math.sin(amplitude / 2))
