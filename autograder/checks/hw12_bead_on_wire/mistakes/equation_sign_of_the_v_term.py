"""Your term 4 c^2 x v^2 has the wrong sign; dL/dv holds 1 + 4 c^2 x^2, whose rate has a term with v^2, too.

fails: lagrange_gives_the_acceleration
"""


def lagrange_equation():
    import sympy

    x, v, c, g = sympy.symbols("x v c g")
    return -2 * c * x * (g - 2 * c * v**2) / (1 + 4 * c**2 * x**2)
