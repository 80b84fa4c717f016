"""The rate of the speed along the wire handed in for x''.

fails: newton_gives_the_acceleration
suspect: the rate of the speed there, taken for x''
"""


def acceleration_newton(x, v, *, curvature, gravity):
    slope = 2 * curvature * x
    return -gravity * slope / np.hypot(1, slope)
