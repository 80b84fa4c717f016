"""The period that does not know the amplitude.

fails: period_is_exact
suspect: the period of small amplitudes
"""

def period(amplitude, *, curvature, gravity):
    return 2 * math.pi / math.sqrt(2 * gravity * curvature)
