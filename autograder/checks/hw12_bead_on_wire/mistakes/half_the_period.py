"""This is half the period; the bead should also come back.

fails: period_is_exact
"""

_right = period


def period(amplitude, *, curvature, gravity):
    return _right(amplitude, curvature=curvature, gravity=gravity) / 2
