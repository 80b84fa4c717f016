"""The orbit has its centre at the origin; it should be at the equilibrium.

fails: orbit_has_its_centre_at_the_equilibrium, orbit_is_the_ellipse_of_the_motion
where: ellipse
"""

_right_orbit = orbit


def orbit(position, velocity, *, mass, stiffness, gravity):
    return _right_orbit(position, velocity, mass=mass, stiffness=stiffness, gravity=0.0)
