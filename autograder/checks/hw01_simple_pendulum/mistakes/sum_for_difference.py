"""The potential energy has the wrong sign.

fails: lagrangian_is_kinetic_less_potential, lagrange_gives_the_acceleration
"""

def lagrangian():
    import sympy

    theta, omega, m, l, g = sympy.symbols("theta omega m l g")
    return m * l**2 * omega**2 / 2 + m * g * l * (1 - sympy.cos(theta))
