"""The term 4 c^2 x v^2 uses the speed along the wire for v, which is the rate of x.

fails: newton_gives_the_acceleration
"""


def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -slope * (gravity + 2 * curvature * v**2 / (1 + slope**2)) / (1 + slope**2)
