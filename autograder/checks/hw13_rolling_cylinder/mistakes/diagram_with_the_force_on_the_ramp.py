"""You drew the force that the cylinder exerts on the ramp.

fails: forces_on_the_cylinder
names: the cylinder exerts on it
"""

_right = free_body_diagram


def free_body_diagram(phi, *, mass, radius, offset, slope, gravity):
    weight, (contact, _), friction = _right(phi, mass=mass, radius=radius, offset=offset, slope=slope, gravity=gravity)
    return [weight, (contact, (0.0, -1.0)), friction]
