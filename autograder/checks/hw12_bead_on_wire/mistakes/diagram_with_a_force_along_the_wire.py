"""You drew a force along the wire; there is no friction.

fails: forces_on_the_bead
names: a force along the wire
"""

_right = free_body_diagram


def free_body_diagram(x, *, mass, curvature, gravity):
    weight, (bead, (x, y)) = _right(x, mass=mass, curvature=curvature, gravity=gravity)
    return [weight, (bead, (x, y)), (bead, (y, -x))]
