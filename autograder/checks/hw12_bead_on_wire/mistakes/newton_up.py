"""Gravity along +y.

fails: newton_gives_the_acceleration
suspect: the sign of gravity's term reversed
"""

def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -slope * (2 * curvature * v**2 - gravity) / (1 + slope**2)
