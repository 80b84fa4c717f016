"""1 + 2 c x where the tangent dotted with itself belongs.

fails: newton_gives_the_acceleration
suspect: the slope 2 c x not squared
"""

def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -(gravity * slope + curvature * v**2) / (1 + slope)
