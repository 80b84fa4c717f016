"""You drew the weight straight into the ramp; it is vertical.

fails: forces_on_the_cylinder
names: straight into the ramp
"""

_right = free_body_diagram


def free_body_diagram(phi, *, mass, radius, offset, slope, gravity):
    (G, _), *contact = _right(phi, mass=mass, radius=radius, offset=offset, slope=slope, gravity=gravity)
    return [(G, (0.0, -1.0)), *contact]
