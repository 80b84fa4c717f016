"""You drew m a as a force; no other body exerts it.

fails: forces_on_the_particle
names: You drew m a as a force
"""

_right = free_body_diagram


def free_body_diagram(state, *, mass, drag, gravity):
    a = state_derivative(0.0, state, mass=mass, drag=drag, gravity=gravity)[2:]
    return [*_right(state, mass=mass, drag=drag, gravity=gravity), (state[:2], a)]
