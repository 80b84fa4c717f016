"""The smaller axis is zero below a fiftieth of the larger.

fails: orbit_is_the_ellipse_of_the_motion
names: The smaller axis is not zero
"""

_right_orbit = orbit


def orbit(*start, **parameters):
    centre, axes = _right_orbit(*start, **parameters)
    larger, smaller = np.linalg.norm(axes, axis=1)
    return centre, axes * [[1], [smaller > 0.02 * larger]]
