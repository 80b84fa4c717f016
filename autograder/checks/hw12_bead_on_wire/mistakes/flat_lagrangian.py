"""The kinetic energy has v for the speed, as on a flat wire.

fails: lagrangian_is_kinetic_less_potential, lagrange_gives_the_acceleration
"""

def lagrangian():
    import sympy

    x, v, m, c, g = sympy.symbols("x v m c g")
    return m * v**2 / 2 - m * g * c * x**2
