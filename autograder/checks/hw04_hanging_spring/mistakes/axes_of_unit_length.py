"""The semi-axes are unit vectors; they should have the lengths of the ellipse's.

fails: orbit_is_the_ellipse_of_the_motion
also: In orbit, a factor is missing
names: The semi-axes are unit vectors
"""

_right_orbit = orbit


def orbit(position, velocity, **parameters):
    centre, axes = _right_orbit(position, velocity, **parameters)
    return centre, axes / np.maximum(np.linalg.norm(axes, axis=1), 1e-300)[:, None]
