"""From 0.1 to 0.45 rad the period has only the first two terms of its series in the amplitude.

fails: period_grows_towards_the_top
numerics: what is left out is the fourth power of a small amplitude
"""

_right_period = period


def period(amplitude, *, length, gravity):
    if 0.1 < amplitude < 0.45:
        return 2 * math.pi * math.sqrt(length / gravity) * (1 + amplitude**2 / 16)
    return _right_period(amplitude, length=length, gravity=gravity)
