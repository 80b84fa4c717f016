"""Orbits are kept by their start; another spring gets the orbit of the first.

fails: orbit_has_its_centre_at_the_equilibrium, orbit_is_the_ellipse_of_the_motion
names: Is anything kept between calls?
"""

_right_orbit, _kept = orbit, {}


def orbit(position, velocity, **parameters):
    key = (*position, *velocity)
    if key not in _kept:
        _kept[key] = _right_orbit(position, velocity, **parameters)
    return _kept[key]
