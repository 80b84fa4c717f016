"""An ellipse within a hundredth of a circle is treated as a circle.

fails: orbit_is_the_ellipse_of_the_motion
names: two radii that give the ellipse need not be its axes
"""

_right_orbit = orbit


def orbit(position, velocity, *, mass, stiffness, gravity):
    centre = np.array([0, 0, -mass * gravity / stiffness])
    p, q = position - centre, velocity * np.sqrt(mass / stiffness)
    if max(abs(p @ q), abs(p @ p - q @ q)) < 1e-2 * (p @ p):
        return centre, np.array([p, q])
    return _right_orbit(position, velocity, mass=mass, stiffness=stiffness, gravity=gravity)
