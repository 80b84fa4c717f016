"""The equation has a mass in it that should cancel.

fails: lagrange_gives_the_acceleration
names: It has m in it
"""

def lagrange_equation():
    import sympy

    x, v, c, g = sympy.symbols("x v c g")
    return -2 * c * x * (g + 2 * c * v**2) / (1 + 4 * c**2 * x**2) * sympy.Symbol('m')
