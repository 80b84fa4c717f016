"""Two radii of equal length are treated as a circle's, whatever the angle between them.

fails: orbit_is_the_ellipse_of_the_motion
names: two radii that give the ellipse need not be its axes
"""

_right_orbit = orbit


def orbit(position, velocity, *, mass, stiffness, gravity):
    centre = np.array([0, 0, -mass * gravity / stiffness])
    p, q = position - centre, velocity * np.sqrt(mass / stiffness)
    if np.isclose(p @ p, q @ q):
        return centre, np.array([p, q])
    return _right_orbit(position, velocity, mass=mass, stiffness=stiffness, gravity=gravity)
