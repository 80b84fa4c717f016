"""These are the first two terms of the series.

fails: period_is_exact
"""

def period(amplitude, *, length, gravity):
    return 2 * math.pi * math.sqrt(length / gravity) * (1 + amplitude**2 / 16)
