"""The sign of the potential energy reversed.

fails: lagrangian_is_kinetic_less_potential, lagrange_gives_the_acceleration
also: the sign of gravity's term missing, as with the sign of the potential energy reversed
"""

def lagrangian():
    import sympy

    theta, omega, m, l, g = sympy.symbols("theta omega m l g")
    return m * l**2 * omega**2 / 2 + m * g * l * (1 - sympy.cos(theta))
