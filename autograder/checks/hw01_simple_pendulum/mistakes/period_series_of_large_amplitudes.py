"""The series in sin(A/2) is too short for large amplitudes.

fails: period_grows_towards_the_top
names: A series in the amplitude
numerics: a series cut short
"""

_right_period = period


def period(amplitude, *, length, gravity):
    if 2 < amplitude < 2.8:
        terms = [(math.comb(2 * n, n) / 4**n * math.sin(amplitude / 2) ** n) ** 2 for n in range(16)]
        return 2 * math.pi * math.sqrt(length / gravity) * sum(terms)
    return _right_period(amplitude, length=length, gravity=gravity)
