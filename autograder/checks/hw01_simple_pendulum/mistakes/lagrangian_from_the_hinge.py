"""The potential energy is zero at the hinge; it should be zero at the lowest point.

fails: lagrangian_is_kinetic_less_potential
"""

def lagrangian():
    import sympy

    theta, omega, m, l, g = sympy.symbols("theta omega m l g")
    return m * l**2 * omega**2 / 2 + m * g * l * sympy.cos(theta)
