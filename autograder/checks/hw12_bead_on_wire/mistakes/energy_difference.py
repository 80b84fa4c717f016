"""T - V where T + V is asked.

fails: energy_is_kinetic_and_potential
suspect: the sign of the potential energy reversed
"""

def energy(x, v, *, mass, curvature, gravity):
    return mass * (1 + (2 * curvature * x) ** 2) * v**2 / 2 - mass * gravity * curvature * x**2
