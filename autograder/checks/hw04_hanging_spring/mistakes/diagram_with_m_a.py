"""You drew m a as a force; no other body exerts it.

fails: forces_on_the_mass
names: You drew m a as a force
"""

_right = free_body_diagram


def free_body_diagram(state, *, mass, stiffness, gravity):
    a = np.array(state_derivative(0.0, state, mass=mass, stiffness=stiffness, gravity=gravity)[3:])
    return [*_right(state, mass=mass, stiffness=stiffness, gravity=gravity), (state[:3], -a)]
