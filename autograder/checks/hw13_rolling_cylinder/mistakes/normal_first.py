"""The components in the other order.

fails: contact_force_accelerates_G
suspect: normal first
"""

_right = contact_force


def contact_force(phi, phi_dot, **cylinder):
    return _right(phi, phi_dot, **cylinder)[::-1]
