"""dT/dx forgotten: the term with v^2 is twice what it is.

fails: lagrange_gives_the_acceleration
suspect: twice the term 4 c^2 x v^2
"""

def lagrange_equation():
    import sympy

    x, v, c, g = sympy.symbols("x v c g")
    return -2 * c * x * (g + 4 * c * v**2) / (1 + 4 * c**2 * x**2)
