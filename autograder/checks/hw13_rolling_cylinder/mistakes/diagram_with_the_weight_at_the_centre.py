"""You drew the weight at the centre; it acts at G.

fails: forces_on_the_cylinder
names: at the wrong point; it acts at G
"""

_right = free_body_diagram


def free_body_diagram(phi, *, mass, radius, offset, slope, gravity):
    (_, down), *contact = _right(phi, mass=mass, radius=radius, offset=offset, slope=slope, gravity=gravity)
    return [((0.0, 0.0), down), *contact]
