"""The slope 2 c x is not squared.

fails: newton_gives_the_acceleration
"""

def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -(gravity * slope + curvature * v**2) / (1 + slope)
