"""You drew m a as a force; no other body exerts it.

fails: forces_on_the_disk
names: Nothing exerts m a
"""

_right = free_body_diagram


def free_body_diagram(state, *, mass, radius, gravity):
    (centre, down), ground = _right(state, mass=mass, radius=radius, gravity=gravity)
    return [(centre, down), ground, (centre, (1.0, 0.5, 0.1))]
