"""The formula is a string; it should be a SymPy expression.

fails: lagrange_gives_the_acceleration
names: does not return a SymPy expression
"""

def lagrange_equation():
    return "-g*sin(theta)/l"
