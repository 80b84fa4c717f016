"""The potential is zero on the ramp; it should be zero with G where the centre is at phi = 0.

fails: energy_of_G_and_of_turning
"""

_right = energy


def energy(phi, phi_dot, **c):
    return _right(phi, phi_dot, **c) + c["mass"] * c["gravity"] * c["radius"] * math.cos(c["slope"])
