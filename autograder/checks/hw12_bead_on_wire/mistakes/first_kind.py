"""The elliptic integral of the pendulum.

fails: period_is_exact
suspect: the integral of the first kind for that of the second
"""

def period(amplitude, *, curvature, gravity):
    from scipy.special import ellipk

    return 4 * ellipk(-((2 * curvature * amplitude) ** 2)) / math.sqrt(2 * gravity * curvature)
