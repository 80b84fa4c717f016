"""The period that does not know the amplitude.

fails: period_is_exact
suspect: the period of small angles
"""

def period(amplitude, *, length, gravity):
    return 2 * math.pi * math.sqrt(length / gravity)
