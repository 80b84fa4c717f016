"""A mass that does not cancel.

fails: lagrange_gives_the_acceleration
names: in theta, l, g alone
"""

def lagrange_equation():
    import sympy

    theta, m, l, g = sympy.symbols("theta m l g")
    return -m * g * sympy.sin(theta) / l
