"""A normal force below zero is cut off to zero; contact is kept.

fails: contact_force_may_pull
"""

_right = contact_force


def contact_force(phi, phi_dot, **cylinder):
    along, normal = _right(phi, phi_dot, **cylinder)
    return along, max(normal, 0.0)
