"""You drew m a as a force; no other body exerts it.

fails: forces_on_the_cylinder
names: Nothing exerts m a
"""

_right = free_body_diagram


def free_body_diagram(phi, *, mass, radius, offset, slope, gravity):
    (G, down), *contact = _right(phi, mass=mass, radius=radius, offset=offset, slope=slope, gravity=gravity)
    return [(G, down), *contact, (G, (1.0, 0.3))]
