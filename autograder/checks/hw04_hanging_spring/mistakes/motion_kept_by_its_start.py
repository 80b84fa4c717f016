"""Motions are kept by times and start; another spring gets the motion of the first.

fails: simulate_does_not_depend_on_the_sampling
names: kept between calls
"""

_right_simulate, _kept = simulate, {}


def simulate(t, position, velocity, **parameters):
    key = (*t, *position, *velocity)
    if key not in _kept:
        _kept[key] = _right_simulate(t, position, velocity, **parameters)
    return _kept[key].copy()
