"""The acceleration of the centre along the ramp, r phi'', for that of G.

fails: contact_force_accelerates_G
names: normal is right, along is not
"""

_right = contact_force


def contact_force(phi, phi_dot, **c):
    turning = acceleration(phi, phi_dot, **c)
    along = c["mass"] * (c["radius"] * turning - c["gravity"] * math.sin(c["slope"]))
    return along, _right(phi, phi_dot, **c)[1]
