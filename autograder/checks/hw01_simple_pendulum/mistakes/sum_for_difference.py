"""T + V for T - V.

fails: lagrangian_is_kinetic_less_potential, lagrange_gives_the_acceleration
suspect: the sign of the potential energy reversed
"""

def lagrangian():
    import sympy

    theta, omega, m, l, g = sympy.symbols("theta omega m l g")
    return m * l**2 * omega**2 / 2 + m * g * l * (1 - sympy.cos(theta))
