"""The period has only the first two terms of its series in the amplitude.

fails: period_is_exact
"""

def period(amplitude, *, length, gravity):
    return 2 * math.pi * math.sqrt(length / gravity) * (1 + amplitude**2 / 16)
