"""Friction's part of the growth with the wheelbase, not its square.

fails: growth_rate_is_the_slope
suspect: the wheelbase where its square belongs
"""


def yaw_growth_rate(speed, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    car = _car(locked, mass, yaw_inertia, front, rear, friction, gravity)
    return (mass * car["free"] * speed - car["drag"] * abs(car["arm"]) / speed) / car["inertia"]
