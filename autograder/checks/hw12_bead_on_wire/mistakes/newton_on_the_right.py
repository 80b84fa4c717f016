"""The slope 2 c x has lost its sign.

fails: newton_gives_the_acceleration
"""

def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -abs(slope) * (gravity + 2 * curvature * v**2) / (1 + slope**2)
