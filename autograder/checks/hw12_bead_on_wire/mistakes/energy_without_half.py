"""The factor 1/2 of the kinetic energy is missing.

fails: energy_is_kinetic_and_potential
"""


def energy(x, v, *, mass, curvature, gravity):
    return mass * v**2 * (1 + (2 * curvature * x) ** 2) + mass * gravity * curvature * x**2
