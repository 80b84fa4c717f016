"""The kinetic energy of a flat wire, v for the speed.

fails: energy_is_kinetic_and_potential
"""

def energy(x, v, *, mass, curvature, gravity):
    return mass * v**2 / 2 + mass * gravity * curvature * x**2
