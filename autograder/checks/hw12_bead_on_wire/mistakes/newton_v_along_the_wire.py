"""v taken for the speed along the wire.

fails: newton_gives_the_acceleration
suspect: with v along the wire
"""


def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -slope * (gravity + 2 * curvature * v**2 / (1 + slope**2)) / (1 + slope**2)
