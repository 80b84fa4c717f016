"""You drew the force of the rod at the hinge; it acts at the mass.

fails: forces_on_the_mass
names: at the wrong point; it acts at the mass
"""

_right = free_body_diagram


def free_body_diagram(theta, omega, *, mass, length, gravity):
    weight, (r, inwards) = _right(theta, omega, mass=mass, length=length, gravity=gravity)
    return [weight, (0 * r, inwards)]
