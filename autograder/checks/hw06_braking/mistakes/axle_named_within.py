"""A part of an axle's name counts as the name, even an empty one.

fails: mechanics_refuses_other_axles, stability_refuses_other_axles
names: does not raise ValueError
"""

_right = _axles


def _axles(locked, front, rear):
    if locked is None or locked not in "front rear":
        raise ValueError(locked)
    return _right("front" if locked in "front" else "rear", front, rear)
