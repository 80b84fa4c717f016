"""The weight is missing in the force along the ramp.

fails: contact_force_accelerates_G
"""

_right = contact_force


def contact_force(phi, phi_dot, **c):
    along, normal = _right(phi, phi_dot, **c)
    return along + c["mass"] * c["gravity"] * math.sin(c["slope"]), normal
