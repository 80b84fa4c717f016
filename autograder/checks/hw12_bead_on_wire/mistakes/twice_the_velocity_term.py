"""The term 4 c^2 x v^2 is there twice: dT/dx is missing.

fails: lagrange_gives_the_acceleration
"""

def lagrange_equation():
    import sympy

    x, v, c, g = sympy.symbols("x v c g")
    return -2 * c * x * (g + 4 * c * v**2) / (1 + 4 * c**2 * x**2)
