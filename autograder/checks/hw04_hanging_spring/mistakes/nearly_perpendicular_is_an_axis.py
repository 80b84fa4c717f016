"""Radii that are perpendicular to a thousandth are treated as axes.

fails: orbit_is_the_ellipse_of_the_motion
names: two radii that give the ellipse need not be its axes
"""

_right_orbit = orbit


def orbit(position, velocity, *, mass, stiffness, gravity):
    centre = np.array([0, 0, -mass * gravity / stiffness])
    p, q = position - centre, velocity * np.sqrt(mass / stiffness)
    if abs(p @ q) < 1e-3 * np.sqrt(p @ p * (q @ q)):
        return centre, np.array(sorted([p, q], key=lambda r: -(r @ r)))
    return _right_orbit(position, velocity, mass=mass, stiffness=stiffness, gravity=gravity)
