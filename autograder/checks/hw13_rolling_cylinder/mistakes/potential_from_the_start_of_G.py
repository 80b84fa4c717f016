"""The potential is zero with G where it is at phi = 0; it should be zero with G where the centre is.

fails: energy_of_G_and_of_turning
"""

_right = energy


def energy(phi, phi_dot, **c):
    return _right(phi, phi_dot, **c) - _right(0.0, 0.0, **c)
