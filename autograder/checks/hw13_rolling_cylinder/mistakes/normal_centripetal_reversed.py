"""Off the ramp, the term in phi_dot squared of G's acceleration has the wrong sign.

fails: contact_force_accelerates_G
"""

_right = contact_force


def contact_force(phi, phi_dot, **c):
    along, normal = _right(phi, phi_dot, **c)
    return along, normal - 2 * c["mass"] * c["offset"] * math.cos(phi) * phi_dot**2
