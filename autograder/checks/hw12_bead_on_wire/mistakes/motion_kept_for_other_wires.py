"""A motion is kept by its start and times, whatever the wire and gravity.

fails: simulate_without_gravity
"""

_simulate, _kept = simulate, {}


def simulate(t, x, v, **wire):
    if (key := (x, v, *t)) not in _kept:
        _kept[key] = _simulate(t, x, v, **wire)
    return _kept[key]
