"""The wheelbase stands where its square belongs.

fails: growth_rate_is_the_slope
"""


def yaw_growth_rate(speed, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    car = _car(locked, mass, yaw_inertia, front, rear, friction, gravity)
    return (mass * car["free"] * speed - car["drag"] * abs(car["arm"]) / speed) / car["inertia"]
