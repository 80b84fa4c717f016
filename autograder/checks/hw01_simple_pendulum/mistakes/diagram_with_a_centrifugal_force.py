"""You drew a centrifugal force along the rod; no other body exerts it.

fails: forces_on_the_mass
names: centrifugal
"""

_right = free_body_diagram


def free_body_diagram(theta, omega, *, mass, length, gravity):
    weight, (r, inwards) = _right(theta, omega, mass=mass, length=length, gravity=gravity)
    return [(r, r), weight, (r, inwards)]
