"""The integral is of the first kind; the period needs the second kind.

fails: period_is_exact
"""

def period(amplitude, *, curvature, gravity):
    from scipy.special import ellipk

    return 4 * ellipk(-((2 * curvature * amplitude) ** 2)) / math.sqrt(2 * gravity * curvature)
