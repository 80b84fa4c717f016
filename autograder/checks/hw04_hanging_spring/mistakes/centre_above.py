"""The centre is above the origin; it should be below.

fails: orbit_has_its_centre_at_the_equilibrium
names: it is above the origin
also: The first result of orbit has the opposite sign
"""

_right_orbit = orbit


def orbit(*start, **parameters):
    centre, axes = _right_orbit(*start, **parameters)
    return -centre, axes
