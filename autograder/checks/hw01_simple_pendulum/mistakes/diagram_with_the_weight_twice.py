"""You drew the weight twice.

fails: forces_on_the_mass
names: You drew the weight twice
"""

_right = free_body_diagram


def free_body_diagram(theta, omega, *, mass, length, gravity):
    weight, rod = _right(theta, omega, mass=mass, length=length, gravity=gravity)
    return [weight, rod, weight]
