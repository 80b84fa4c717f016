"""The part by the speed is positive with either axle locked; with the front locked it should be negative.

fails: small_yaw_rate_is_the_linear_solution
"""


def small_yaw_rate(speed, speed0, yaw_rate0, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    car = _car(locked, mass, yaw_inertia, front, rear, friction, gravity)
    power = mass * car["arm"] ** 2 / car["inertia"]
    growth = mass**2 * abs(car["free"]) * (speed0**2 - speed**2) / (2 * car["drag"] * car["inertia"])
    return yaw_rate0 * math.exp(growth + power * math.log(speed / speed0))
