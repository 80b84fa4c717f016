"""You drew two components of the weight; draw it as one arrow.

fails: forces_on_the_cylinder
names: You drew components of the weight
"""

_right = free_body_diagram


def free_body_diagram(phi, *, mass, radius, offset, slope, gravity):
    (G, (x, y)), *contact = _right(phi, mass=mass, radius=radius, offset=offset, slope=slope, gravity=gravity)
    return [(G, (x, 0.0)), (G, (0.0, y)), *contact]
