"""x is left as a function of time; it should be a symbol.

fails: lagrange_gives_the_acceleration
names: It has x(t) in it
"""

def lagrange_equation():
    import sympy

    t, v, c, g = sympy.symbols("t v c g")
    x = sympy.Function("x")(t)
    return -2 * c * x * (g + 2 * c * v**2) / (1 + 4 * c**2 * x**2)
