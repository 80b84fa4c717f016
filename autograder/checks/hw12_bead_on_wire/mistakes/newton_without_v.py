"""y'' = 2 c x x'' alone, the term 2 c v^2 left out.

fails: newton_gives_the_acceleration
suspect: the term 4 c^2 x v^2 missing
"""

def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -slope * gravity / (1 + slope**2)
