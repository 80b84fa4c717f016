"""The acceleration has a mass in it that should cancel.

fails: lagrange_gives_the_acceleration
names: It has m in it
"""

def lagrange_equation():
    import sympy

    theta, m, l, g = sympy.symbols("theta m l g")
    return -m * g * sympy.sin(theta) / l
