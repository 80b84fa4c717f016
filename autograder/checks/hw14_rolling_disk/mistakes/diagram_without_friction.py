"""You drew the force of the ground straight up; a disk that rolls needs friction.

fails: forces_on_the_disk
names: no component of it is known
"""

_right = free_body_diagram


def free_body_diagram(state, *, mass, radius, gravity):
    weight, (contact, _) = _right(state, mass=mass, radius=radius, gravity=gravity)
    return [weight, (contact, (0.0, 0.0, 1.0))]
