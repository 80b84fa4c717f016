"""The curvature beside v^2 is missing.

fails: newton_gives_the_acceleration
"""

def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -slope * (gravity + 2 * v**2) / (1 + slope**2)
