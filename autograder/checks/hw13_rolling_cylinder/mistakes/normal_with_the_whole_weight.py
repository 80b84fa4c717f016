"""The cosine of the slope is missing in the normal force.

fails: contact_force_accelerates_G
"""

_right = contact_force


def contact_force(phi, phi_dot, **c):
    along, normal = _right(phi, phi_dot, **c)
    return along, normal + c["mass"] * c["gravity"] * (1 - math.cos(c["slope"]))
