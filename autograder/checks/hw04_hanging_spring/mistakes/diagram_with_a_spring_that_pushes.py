"""You let the spring push; it pulls towards the origin.

fails: forces_on_the_mass
names: You let the spring push
"""

_right = free_body_diagram


def free_body_diagram(state, *, mass, stiffness, gravity):
    weight, (r, pull) = _right(state, mass=mass, stiffness=stiffness, gravity=gravity)
    return [weight, (r, -np.array(pull))]
