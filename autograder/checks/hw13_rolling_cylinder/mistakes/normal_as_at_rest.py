"""The normal force carries only the weight, as at rest.

fails: contact_force_accelerates_G
"""

_right = contact_force


def contact_force(phi, phi_dot, **c):
    return _right(phi, phi_dot, **c)[0], c["mass"] * c["gravity"] * math.cos(c["slope"])
