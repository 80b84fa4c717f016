"""Kinetic energy of v alone.

fails: energy_is_kinetic_and_potential
suspect: the kinetic energy of a flat wire
"""

def energy(x, v, *, mass, curvature, gravity):
    return mass * v**2 / 2 + mass * gravity * curvature * x**2
