"""The acceleration of G off the ramp without its part with phi''.

fails: contact_force_accelerates_G
"""

_right = contact_force


def contact_force(phi, phi_dot, **c):
    along, normal = _right(phi, phi_dot, **c)
    return along, normal - c["mass"] * c["offset"] * math.sin(phi) * acceleration(phi, phi_dot, **c)
