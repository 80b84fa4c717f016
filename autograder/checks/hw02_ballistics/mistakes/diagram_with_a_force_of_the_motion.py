"""You drew a force along the velocity; nothing pushes the particle after the launch.

fails: forces_on_the_particle
names: no other body pushes the particle
"""

_right = free_body_diagram


def free_body_diagram(state, *, mass, drag, gravity):
    return [*_right(state, mass=mass, drag=drag, gravity=gravity), (state[:2], state[2:])]
