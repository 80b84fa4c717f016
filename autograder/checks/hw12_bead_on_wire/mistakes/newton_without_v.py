"""The term 4 c^2 x v^2 is missing.

fails: newton_gives_the_acceleration
"""

def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -slope * gravity / (1 + slope**2)
