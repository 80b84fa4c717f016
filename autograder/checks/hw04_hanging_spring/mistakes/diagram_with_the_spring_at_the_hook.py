"""You drew the force of the spring at the origin; it acts at the mass.

fails: forces_on_the_mass
names: at the wrong point; it acts at the mass
"""

_right = free_body_diagram


def free_body_diagram(state, *, mass, stiffness, gravity):
    weight, (r, pull) = _right(state, mass=mass, stiffness=stiffness, gravity=gravity)
    return [weight, (np.zeros(3), pull)]
