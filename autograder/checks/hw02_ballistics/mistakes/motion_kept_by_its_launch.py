"""A motion is kept by times and launch; other drag gets the same motion.

fails: simulation_without_drag_or_gravity
names: kept between calls
"""

_right_simulate, _kept = simulate, {}


def simulate(t, speed, angle, **known):
    key = (*t, speed, angle)
    if key not in _kept:
        _kept[key] = _right_simulate(t, speed, angle, **known)
    return _kept[key].copy()
