"""The smaller axis comes first; the larger should.

fails: orbit_is_the_ellipse_of_the_motion
names: the larger axis is not the first
"""

_right_orbit = orbit


def orbit(*start, **parameters):
    centre, axes = _right_orbit(*start, **parameters)
    return centre, axes[::-1]
