"""You drew a centrifugal force along the normal.

fails: forces_on_the_bead
names: centrifugal
"""

_right = free_body_diagram


def free_body_diagram(x, *, mass, curvature, gravity):
    weight, (bead, (x, y)) = _right(x, mass=mass, curvature=curvature, gravity=gravity)
    return [weight, (bead, (x, y)), (bead, (-x, -y))]
