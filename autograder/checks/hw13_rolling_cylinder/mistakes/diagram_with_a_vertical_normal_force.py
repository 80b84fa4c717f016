"""You drew the normal force along the vertical; it is normal to the ramp.

fails: forces_on_the_cylinder
names: along the vertical
"""

_right = free_body_diagram


def free_body_diagram(phi, *, mass, radius, offset, slope, gravity):
    weight, _, friction = _right(phi, mass=mass, radius=radius, offset=offset, slope=slope, gravity=gravity)
    return [weight, (friction[0], (-weight[1][0], -weight[1][1])), friction]
