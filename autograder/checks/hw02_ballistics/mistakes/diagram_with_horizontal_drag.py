"""You drew drag along x only; it opposes the whole velocity.

fails: forces_on_the_particle
names: You left out the drag
"""

_right = free_body_diagram


def free_body_diagram(state, *, mass, drag, gravity):
    weight, (r, (x, _)) = _right(state, mass=mass, drag=drag, gravity=gravity)
    return [weight, (r, (x, 0.0))]
