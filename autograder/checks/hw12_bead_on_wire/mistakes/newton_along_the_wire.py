"""x'' is the rate of the speed along the wire; it should be the rate of v along x.

fails: newton_gives_the_acceleration
"""


def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -gravity * slope / np.hypot(1, slope)
