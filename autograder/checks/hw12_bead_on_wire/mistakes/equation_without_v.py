"""The rate of dT/dv without the term in which x changes.

fails: lagrange_gives_the_acceleration
suspect: the term 4 c^2 x v^2 missing
"""

def lagrange_equation():
    import sympy

    x, v, c, g = sympy.symbols("x v c g")
    return -2 * c * g * x / (1 + 4 * c**2 * x**2)
