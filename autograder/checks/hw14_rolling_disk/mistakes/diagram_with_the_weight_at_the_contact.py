"""You drew the weight at the contact; it acts at the centre.

fails: forces_on_the_disk
names: at the wrong point; it acts at the centre
"""

_right = free_body_diagram


def free_body_diagram(state, *, mass, radius, gravity):
    (_, down), (contact, _) = _right(state, mass=mass, radius=radius, gravity=gravity)
    return [(contact, down), (contact, None)]
