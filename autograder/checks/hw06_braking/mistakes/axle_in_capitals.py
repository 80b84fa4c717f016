"""The axle's name is accepted in any case; only lower case is right.

fails: mechanics_refuses_other_axles, stability_refuses_other_axles
names: does not raise ValueError
"""

_right = _axles


def _axles(locked, front, rear):
    return _right(locked.lower() if isinstance(locked, str) else locked, front, rear)
