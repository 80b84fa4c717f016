"""The period has only ten terms of its series, too few for a pendulum that swings above the hinge.

fails: period_is_exact
numerics: the length of the series
"""


def period(amplitude, *, length, gravity):
    k, term, total = math.sin(amplitude / 2), 1.0, 1.0
    for n in range(1, 10):
        term *= ((2 * n - 1) / (2 * n) * k) ** 2
        total += term
    return 2 * math.pi * math.sqrt(length / gravity) * total
