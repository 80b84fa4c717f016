"""theta is left as a function of time; it should be a symbol.

fails: lagrangian_is_kinetic_less_potential
names: It has theta(t) in it
"""


def lagrangian():
    import sympy

    m, l, g, t, omega = sympy.symbols("m l g t omega")
    theta = sympy.Function("theta")(t)
    return m * l**2 * omega**2 / 2 - m * g * l * (1 - sympy.cos(theta))


def lagrange_equation():
    import sympy

    theta, l, g = sympy.symbols("theta l g")
    return -g / l * sympy.sin(theta)
