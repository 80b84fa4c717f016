"""The period is a series of eighty terms, which is too short near pi.

fails: period_grows_towards_the_top
names: a series in the amplitude
"""

def period(amplitude, *, length, gravity):
    m, term, total = math.sin(amplitude / 2) ** 2, 1.0, 1.0
    for n in range(1, 80):
        term *= ((2 * n - 1) / (2 * n)) ** 2 * m
        total += term
    return 2 * math.pi * math.sqrt(length / gravity) * total
