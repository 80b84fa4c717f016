"""The first correction to the period of small angles.

fails: period_is_exact
suspect: the first two terms of the series
"""

def period(amplitude, *, length, gravity):
    return 2 * math.pi * math.sqrt(length / gravity) * (1 + amplitude**2 / 16)
