"""The kinetic energy has v for the speed, as on a flat wire.

fails: energy_is_kinetic_and_potential
"""

def energy(x, v, *, mass, curvature, gravity):
    return mass * v**2 / 2 + mass * gravity * curvature * x**2
