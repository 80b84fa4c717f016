"""The term 4 c^2 x v^2 has the wrong sign: dT/dx is subtracted from the rate of dT/dv.

fails: lagrange_gives_the_acceleration
"""


def lagrange_equation():
    import sympy

    x, v, c, g = sympy.symbols("x v c g")
    return -2 * c * x * (g - 2 * c * v**2) / (1 + 4 * c**2 * x**2)
