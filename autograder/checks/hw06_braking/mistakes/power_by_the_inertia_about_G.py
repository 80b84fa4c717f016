"""Friction's part has the inertia about G where the inertia about the free axle belongs.

fails: small_yaw_rate_is_the_linear_solution
"""

_right = small_yaw_rate


def small_yaw_rate(speed, speed0, yaw_rate0, locked, **c):
    free, arm = _axles(locked, c["front"], c["rear"])
    more = c["mass"] * arm**2 * (1 / c["yaw_inertia"] - 1 / (c["yaw_inertia"] + c["mass"] * free**2))
    return _right(speed, speed0, yaw_rate0, locked, **c) * (speed / speed0) ** more
