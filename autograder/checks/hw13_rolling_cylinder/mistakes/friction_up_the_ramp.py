"""The force along the ramp is positive up the ramp; it should be positive down.

fails: contact_force_accelerates_G
"""

_right = contact_force


def contact_force(phi, phi_dot, **cylinder):
    along, normal = _right(phi, phi_dot, **cylinder)
    return -along, normal
