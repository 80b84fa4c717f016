"""The energy lacks the kinetic energy of G's motion.

fails: energy_of_G_and_of_turning
"""

_right = energy


def energy(phi, phi_dot, **c):
    return _right(phi, 0.0, **c) + c["inertia"] * phi_dot**2 / 2
