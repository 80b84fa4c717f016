"""The first terms of the series in c A are not enough: the period is exact.

fails: period_is_exact
"""


def period(amplitude, *, curvature, gravity):
    return 2 * math.pi / math.sqrt(2 * gravity * curvature) * (1 + (curvature * amplitude) ** 2)
