"""x'' is not the rate of the speed along the wire.

fails: newton_gives_the_acceleration
"""


def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -gravity * slope / np.hypot(1, slope)
