"""This is the period of small amplitudes; it should hold for any amplitude.

fails: period_is_exact
"""

def period(amplitude, *, curvature, gravity):
    return 2 * math.pi / math.sqrt(2 * gravity * curvature)
