"""theta stands for sin theta: this is the linearised equation.

fails: lagrange_gives_the_acceleration
"""

def lagrange_equation():
    import sympy

    theta, l, g = sympy.symbols("theta l g")
    return -g * theta / l
