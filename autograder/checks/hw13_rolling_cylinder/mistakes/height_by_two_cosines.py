"""The height of G has cos(phi) cos(slope) where cos(phi + slope) belongs.

fails: energy_of_G_and_of_turning
"""

_right = energy


def energy(phi, phi_dot, **c):
    more = math.cos(phi + c["slope"]) - math.cos(phi) * math.cos(c["slope"])
    return _right(phi, phi_dot, **c) + c["mass"] * c["gravity"] * c["offset"] * more
