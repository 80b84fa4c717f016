"""The term with gravity has the wrong sign.

fails: newton_gives_the_acceleration
"""

def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -slope * (2 * curvature * v**2 - gravity) / (1 + slope**2)
