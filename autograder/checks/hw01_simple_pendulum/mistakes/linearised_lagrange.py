"""Lagrange's equation for small angles.

fails: lagrange_gives_the_acceleration
suspect: the linearised equation, theta for sin theta
"""

def lagrange_equation():
    import sympy

    theta, l, g = sympy.symbols("theta l g")
    return -g * theta / l
