"""You drew a force beside the disk; nothing touches it there.

fails: forces_on_the_disk
names: that no other body exerts
"""

_right = free_body_diagram


def free_body_diagram(state, *, mass, radius, gravity):
    return [*_right(state, mass=mass, radius=radius, gravity=gravity), ((state[0], state[1], 1.0), (0.0, 1.0, 0.0))]
