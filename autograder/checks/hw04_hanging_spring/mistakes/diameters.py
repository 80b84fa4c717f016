"""The result has whole axes; it should have semi-axes.

fails: orbit_is_the_ellipse_of_the_motion
also: twice as large as the right one
names: not semi-axes
"""

_right_orbit = orbit


def orbit(*start, **parameters):
    centre, axes = _right_orbit(*start, **parameters)
    return centre, 2 * axes
