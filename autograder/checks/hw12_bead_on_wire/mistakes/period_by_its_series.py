"""The period has only the first terms of its series in c A; it should be exact.

fails: period_is_exact
"""


def period(amplitude, *, curvature, gravity):
    return 2 * math.pi / math.sqrt(2 * gravity * curvature) * (1 + (curvature * amplitude) ** 2)
