"""The yaw rate has only friction's part, a power of the speed; the exponential is missing.

fails: small_yaw_rate_is_the_linear_solution
"""


def small_yaw_rate(speed, speed0, yaw_rate0, locked, **car):
    c = _car(locked, **car)
    return yaw_rate0 * (speed / speed0) ** (c["mass"] * c["arm"] ** 2 / c["inertia"])
