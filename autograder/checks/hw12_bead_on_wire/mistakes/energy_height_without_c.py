"""The height is x^2; it should be c x^2.

fails: energy_is_kinetic_and_potential
"""


def energy(x, v, *, mass, curvature, gravity):
    return mass * v**2 * (1 + (2 * curvature * x) ** 2) / 2 + mass * gravity * x**2
