"""You drew the force of the wire along the vertical; it is normal to the wire.

fails: forces_on_the_bead
names: along the vertical
"""

_right = free_body_diagram


def free_body_diagram(x, *, mass, curvature, gravity):
    weight, (bead, _) = _right(x, mass=mass, curvature=curvature, gravity=gravity)
    return [weight, (bead, (0.0, 1.0))]
