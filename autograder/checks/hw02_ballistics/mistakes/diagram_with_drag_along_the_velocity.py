"""You drew drag along the velocity; on the particle it opposes the velocity.

fails: forces_on_the_particle
names: the particle exerts on the air
"""

_right = free_body_diagram


def free_body_diagram(state, *, mass, drag, gravity):
    weight, (r, _) = _right(state, mass=mass, drag=drag, gravity=gravity)
    return [weight, (r, state[2:])]
