"""The speed of the centre stands where the speed of G belongs.

fails: energy_of_G_and_of_turning
"""

_right = energy


def energy(phi, phi_dot, **c):
    return _right(phi, 0.0, **c) + (c["inertia"] + c["mass"] * c["radius"] ** 2) * phi_dot**2 / 2
