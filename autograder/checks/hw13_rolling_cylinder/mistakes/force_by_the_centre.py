"""The acceleration along the ramp belongs to the centre, r phi'', not to G.

fails: contact_force_accelerates_G
"""

_right = contact_force


def contact_force(phi, phi_dot, **c):
    turning = acceleration(phi, phi_dot, **c)
    along = c["mass"] * (c["radius"] * turning - c["gravity"] * math.sin(c["slope"]))
    return along, _right(phi, phi_dot, **c)[1]
