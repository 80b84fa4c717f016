"""The distance from G to the locked axle stands where the wheelbase belongs.

fails: growth_rate_is_the_slope
"""


def yaw_growth_rate(speed, locked, *, mass, yaw_inertia, front, rear, friction, gravity):
    free, arm = _axles(locked, front, rear)
    drag = friction * axle_load(locked, mass=mass, front=front, rear=rear, gravity=gravity)
    return (mass * free * speed - drag * (free + arm) ** 2 / speed) / (yaw_inertia + mass * free**2)
