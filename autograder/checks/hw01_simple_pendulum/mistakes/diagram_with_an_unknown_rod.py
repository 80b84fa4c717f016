"""You wrote None for the rod; its force acts along it.

fails: forces_on_the_mass
names: its line is known
"""

_right = free_body_diagram


def free_body_diagram(theta, omega, *, mass, length, gravity):
    weight, (r, _) = _right(theta, omega, mass=mass, length=length, gravity=gravity)
    return [weight, (r, None)]
