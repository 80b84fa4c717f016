"""Every name except "front" counts as "rear".

fails: mechanics_refuses_other_axles, stability_refuses_other_axles
names: does not raise ValueError
"""

_right = _axles


def _axles(locked, front, rear):
    return _right("front" if locked == "front" else "rear", front, rear)
