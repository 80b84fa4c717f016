"""The linearised equation, theta for sin theta.

fails: lagrange_gives_the_acceleration
"""

def lagrange_equation():
    import sympy

    theta, l, g = sympy.symbols("theta l g")
    return -g * theta / l
