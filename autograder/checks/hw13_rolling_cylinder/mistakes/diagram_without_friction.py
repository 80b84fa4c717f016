"""You left out the friction; without it the cylinder slips.

fails: forces_on_the_cylinder
names: You left out the friction
"""

_right = free_body_diagram


def free_body_diagram(phi, *, mass, radius, offset, slope, gravity):
    return _right(phi, mass=mass, radius=radius, offset=offset, slope=slope, gravity=gravity)[:2]
