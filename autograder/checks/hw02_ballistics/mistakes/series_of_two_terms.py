"""Where c t/m is below 0.001 the first two terms of a series stand in for the closed form: they have six digits there.

fails: trajectory_with_any_drag
where: very little drag
within: 1e-11
"""

_right_decays = _decays


def _decays(s):
    if abs(s) < 0.001:
        return math.exp(-s), 1 - s / 2, 1 / 2 - s / 6
    return _right_decays(s)
