"""Amplitudes below a hundredth get the period of small angles.

fails: period_grows_towards_the_top
names: no amplitude is small enough
numerics: what is left out is the square of a small amplitude
"""

_right_period = period


def period(amplitude, *, length, gravity):
    if amplitude < 0.01:
        return 2 * math.pi * math.sqrt(length / gravity)
    return _right_period(amplitude, length=length, gravity=gravity)
