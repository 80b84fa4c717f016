"""The part by the speed is positive with either axle locked; with the front locked it should be negative.

fails: growth_rate_is_the_slope
"""


def yaw_growth_rate(speed, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    car = _car(locked, mass, yaw_inertia, front, rear, friction, gravity)
    return (mass * abs(car["free"]) * speed - car["drag"] * car["arm"] ** 2 / speed) / car["inertia"]
