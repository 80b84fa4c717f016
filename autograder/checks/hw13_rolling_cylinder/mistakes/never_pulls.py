"""You cut a negative normal force to 0; assume that the cylinder never lifts off.

fails: contact_force_may_pull
"""

_right = contact_force


def contact_force(phi, phi_dot, **cylinder):
    along, normal = _right(phi, phi_dot, **cylinder)
    return along, max(normal, 0.0)
