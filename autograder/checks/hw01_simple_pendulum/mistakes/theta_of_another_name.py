"""The formula calls the angle theta_1; its symbol should be theta.

fails: lagrange_gives_the_acceleration
names: It has theta_1 in it
"""


def lagrange_equation():
    import sympy

    theta, l, g = sympy.symbols("theta_1 l g")
    return -g / l * sympy.sin(theta)
