"""You drew a centrifugal force along the rod; no other body exerts it.

fails: forces_on_the_particle
names: centrifugal
"""

_right = free_body_diagram


def free_body_diagram(state, *, mass, length, gravity):
    return [*_right(state, mass=mass, length=length, gravity=gravity), (state[:2], state[:2])]
