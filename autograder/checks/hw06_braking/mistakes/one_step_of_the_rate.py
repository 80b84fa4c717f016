"""The growth rate at the speed half way is used at every speed.

fails: small_yaw_rate_is_the_linear_solution
"""


def small_yaw_rate(speed, speed0, yaw_rate0, locked, **car):
    c = _car(locked, **car)
    time = (speed0 - speed) * c["mass"] / c["drag"]
    return yaw_rate0 * math.exp(yaw_growth_rate((speed + speed0) / 2, locked, **car) * time)
