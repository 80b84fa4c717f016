"""Any name that begins with an axle's first letter counts as that axle.

fails: mechanics_refuses_other_axles, stability_refuses_other_axles
names: does not raise ValueError
"""

_right = _axles


def _axles(locked, front, rear):
    return _right({"f": "front", "r": "rear"}.get(str(locked)[:1], locked), front, rear)
