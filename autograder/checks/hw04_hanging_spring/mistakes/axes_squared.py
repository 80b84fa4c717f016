"""The semi-axes have the squares of their lengths; the eigenvalues are these squares.

fails: orbit_is_the_ellipse_of_the_motion
names: The semi-axes have the squares of their lengths
"""

_right_orbit = orbit


def orbit(position, velocity, **parameters):
    centre, axes = _right_orbit(position, velocity, **parameters)
    return centre, axes * np.linalg.norm(axes, axis=1)[:, None]
