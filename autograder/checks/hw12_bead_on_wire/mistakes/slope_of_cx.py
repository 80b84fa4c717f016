"""The slope is c x; it should be 2 c x.

fails: lagrangian_is_kinetic_less_potential
"""

def lagrangian():
    import sympy

    x, v, m, c, g = sympy.symbols("x v m c g")
    return m * (1 + c**2 * x**2) * v**2 / 2 - m * g * c * x**2


def lagrange_equation():
    import sympy

    x, v, c, g = sympy.symbols("x v c g")
    return -2 * c * x * (g + 2 * c * v**2) / (1 + 4 * c**2 * x**2)
