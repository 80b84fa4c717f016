"""2 c^2 x^2 for the square of the slope, 4 c^2 x^2.

fails: energy_is_kinetic_and_potential
"""


def energy(x, v, *, mass, curvature, gravity):
    return mass * v**2 * (1 + 2 * curvature**2 * x**2) / 2 + mass * gravity * curvature * x**2
