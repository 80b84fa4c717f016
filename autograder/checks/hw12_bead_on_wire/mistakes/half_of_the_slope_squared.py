"""Half of y'^2 is missing: the square of the slope is 4 c^2 x^2, not 2 c^2 x^2.

fails: lagrangian_is_kinetic_less_potential, lagrange_gives_the_acceleration, energy_is_kinetic_and_potential
"""


def lagrangian():
    import sympy

    x, v, m, c, g = sympy.symbols("x v m c g")
    return m * v**2 * (1 + 2 * c**2 * x**2) / 2 - m * g * c * x**2


def energy(x, v, *, mass, curvature, gravity):
    return mass * v**2 * (1 + 2 * curvature**2 * x**2) / 2 + mass * gravity * curvature * x**2
