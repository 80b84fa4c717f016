"""The term 4 c^2 x v^2 is missing.

fails: lagrange_gives_the_acceleration
"""

def lagrange_equation():
    import sympy

    x, v, c, g = sympy.symbols("x v c g")
    return -2 * c * g * x / (1 + 4 * c**2 * x**2)
