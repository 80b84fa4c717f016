"""You drew m a as a force; no other body exerts it.

fails: forces_on_the_particle
names: You drew m a as a force
"""

_right = free_body_diagram


def free_body_diagram(state, *, mass, length, gravity):
    return [*_right(state, mass=mass, length=length, gravity=gravity), (state[:2], acceleration(state, mass=mass, length=length, gravity=gravity))]
