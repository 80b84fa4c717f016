"""You left out the force of the rod.

fails: forces_on_the_mass
names: You left out the force of the rod
"""

_right = free_body_diagram


def free_body_diagram(theta, omega, *, mass, length, gravity):
    return _right(theta, omega, mass=mass, length=length, gravity=gravity)[:1]
