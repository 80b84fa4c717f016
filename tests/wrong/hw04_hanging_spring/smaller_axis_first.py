"""The smaller axis first.

fails: orbit_is_the_ellipse_of_the_motion
"""

_right_orbit = orbit


def orbit(*start, **parameters):
    centre, axes = _right_orbit(*start, **parameters)
    return centre, axes[::-1]
