"""Where the slope is below 0.001, x'' is the one of small motions, which lacks the term with v^2.

fails: newton_gives_the_acceleration
"""

_newton = acceleration_newton


def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -slope * gravity if abs(slope) < 1e-3 else _newton(x, v, curvature=curvature, gravity=gravity)
