"""The potential energy has the wrong sign.

fails: energy_is_kinetic_and_potential
"""

def energy(x, v, *, mass, curvature, gravity):
    return mass * (1 + (2 * curvature * x) ** 2) * v**2 / 2 - mass * gravity * curvature * x**2
