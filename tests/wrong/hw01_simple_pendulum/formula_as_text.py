"""The formula as a string.

fails: lagrange_gives_the_acceleration
"""

def lagrange_equation():
    return "-g*sin(theta)/l"
