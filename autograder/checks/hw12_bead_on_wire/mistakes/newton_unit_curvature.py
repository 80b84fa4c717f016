"""2 v^2 for 2 c v^2: right for a curvature of one.

fails: newton_gives_the_acceleration
suspect: the curvature missing beside v^2
"""

def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -slope * (gravity + 2 * v**2) / (1 + slope**2)
