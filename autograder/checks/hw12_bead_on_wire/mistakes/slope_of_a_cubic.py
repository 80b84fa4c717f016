"""The slope is 3 c x^2; it should be 2 c x. The equation follows from this Lagrangian.

fails: lagrangian_is_kinetic_less_potential, lagrange_gives_the_acceleration
names: It follows from your Lagrangian
"""


def lagrangian():
    import sympy

    x, v, m, c, g = sympy.symbols("x v m c g")
    return m * (1 + 9 * c**2 * x**4) * v**2 / 2 - m * g * c * x**2


follows = lagrange_equation


def lagrange_equation():
    return follows()  # from this Lagrangian, in a submission of another style too
