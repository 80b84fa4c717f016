"""You drew the weight upwards; the force on the mass is down.

fails: forces_on_the_mass
names: the body exerts on the earth
"""

_right = free_body_diagram


def free_body_diagram(theta, omega, *, mass, length, gravity):
    (r, _), rod = _right(theta, omega, mass=mass, length=length, gravity=gravity)
    return [(r, (0.0, 1.0)), rod]
