"""The force along the ramp holds only the weight, as at rest.

fails: contact_force_accelerates_G
"""

_right = contact_force


def contact_force(phi, phi_dot, **c):
    return -c["mass"] * c["gravity"] * math.sin(c["slope"]), _right(phi, phi_dot, **c)[1]
