"""The part with phi'' is missing in the acceleration of G off the ramp.

fails: contact_force_accelerates_G
"""

_right = contact_force


def contact_force(phi, phi_dot, **c):
    along, normal = _right(phi, phi_dot, **c)
    return along, normal - c["mass"] * c["offset"] * math.sin(phi) * acceleration(phi, phi_dot, **c)
