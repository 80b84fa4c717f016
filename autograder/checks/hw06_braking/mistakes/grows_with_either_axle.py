"""The free axle's distance from G without its sign: with the front locked the speed drives it, too.

fails: growth_rate_is_the_slope
suspect: positive with either axle locked
"""


def yaw_growth_rate(speed, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    car = _car(locked, mass, yaw_inertia, front, rear, friction, gravity)
    return (mass * abs(car["free"]) * speed - car["drag"] * car["arm"] ** 2 / speed) / car["inertia"]
